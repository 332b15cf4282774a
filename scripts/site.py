"""Hooks of share/mkdocs.yml: the navigation is the list of share/doc/README.md, and lists are indented for Python-Markdown."""
import re


def on_config(config):
    """Sections and pages from README.md: a heading per section, a link at the beginning of each row or item."""
    config["nav"] = [{"Contents": "README.md"}]
    with open(config["docs_dir"] + "/README.md", encoding="utf-8") as readme:
        for line in readme:
            if line.startswith("## "):
                config["nav"].append({line[3:].strip(): []})
            elif (link := re.match(r"(?:\| |- )\[([^]]+)\]\(([^)#]+\.md)\)", line)) and len(config["nav"]) > 1:
                next(iter(config["nav"][-1].values())).append({link[1]: link[2]})
    return config


def on_page_markdown(markdown, **_):
    """What belongs to an item of a list is indented by two blanks here, by four in Python-Markdown."""
    lines, in_list, in_code = [], False, False
    for line in markdown.split("\n"):
        if line.lstrip().startswith("```"):
            in_code = not in_code
        if re.match(r"(- |\d+\. )", line) and not in_code:
            if not in_list and lines and lines[-1]:
                lines.append("")
            in_list = True
        elif line and not line.startswith(" "):
            in_list = False
        indent = len(line) - len(line.lstrip(" "))
        lines.append(" " * indent + line if in_list else line)
    return "\n".join(lines)
