-- An SVG document whose names (of clip paths, glyphs, images) have a prefix: those of several pictures in one page
-- would otherwise be equal. Texts are left as they are.

return function(svg, prefix)
  return (svg:gsub("<[^>]->", function(tag)
    return (tag:gsub('( id=")', "%1" .. prefix):gsub('(href="#)', "%1" .. prefix):gsub("(url%(#)", "%1" .. prefix))
  end))
end
