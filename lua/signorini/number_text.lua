--- The shortest decimal text that reads back as the same number; finite numbers only.
return require("signorini.core").number_text
