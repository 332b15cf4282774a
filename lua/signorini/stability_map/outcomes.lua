-- How a cell of a stability map can end: the reasons of model:run, and what happens to the cell as a whole. Their order
-- is that of the legend, and gives each its colour in every picture.

return {
  "completed", "stopped", "interrupted", "cut", "iterations", "diverged", "cycling", "lost_projection", "inverted",
  "singular", "indefinite", "nan", "line_search", "penetration", "turning_point", "minimum_step", "strayed",
  "error", "crashed", "time",
}
