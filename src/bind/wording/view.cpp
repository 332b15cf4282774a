#include "bind/wording/wording.hpp"

namespace signorini::bind {

namespace {

constexpr Wording view_rows[] = {
    {"view.flat.failed", "Cairo did not draw a figure of {width} × {height} pixels: {reason}"},
    {"view.png.failed", "the PNG file could not be made: {reason}"},
    {"view.camera.unknown", "camera must be one of {known}, got '{camera}'"},
    {"view.camera.finite", "the camera's from and up must be finite numbers"},
    {"view.camera.zero",
     "the camera's from and up must not be zero: from points from the scene to the eye, up to the picture's top"},
    {"view.camera.parallel", "the camera's up must not point along from. Hint: choose another up, such as {{0, 1, 0}}"},
    {"view.legend.categories",
     "the legend of {count} categories does not fit next to the map. Hint: choose a larger size"},
    {"view.chart.log", "{series} has {axis} = {value} on a logarithmic axis, which shows only values above 0. Hint: "
                       "leave '{axis}' out of log or drop such points"},
    {"view.chart.empty", "a chart needs at least one series, got none. Hint: give one such as {{ y = {{1, 2, 3}} }}"},
    {"view.chart.sizes", "{series} must have as many x values as y values, got {xs} and {ys}"},
    {"view.chart.marks", "{series} must have one mark per point, or none, got {marks:mark} for {points:point}"},
    {"view.chart.mark", "{series} has mark {mark}; the chart names {count}"},
    {"view.chart.invisible", "{series} has neither line nor markers. Hint: switch one of them on"},
    {"view.chart.kinds",
     "the chart has {count} kinds of points, and there are {most} markers. Hint: mark fewer kinds, or none"},
    {"view.chart.no_point", "the chart's series hold no finite point; nothing can be drawn"},
    {"view.chart.many_curves", "the chart has {count} curves, of which colors and dashes tell {distinct} apart; the "
                               "others look like the first ones. Hint: draw several charts, or give color"},
    {"view.chart.series", "series {number:+1}"},
    {"view.chart.named_series", "series {number:+1} '{label}'"},
    {"view.chart.ticks", "xticks must rise, but '{name}' at {at} follows '{before}' at {at_before}"},
    {"view.chart.place", "{what} '{name}' must stand at a finite number, got {axis} = {at}"},
    {"view.chart.place_log",
     "{what} '{name}' must stand at a finite number above 0, as the axis is logarithmic, got {axis} = {at}"},
    {"view.chart.no_curve", "no curve runs between x = {low} and {high}. Hint: choose an xrange that holds data"},
    {"view.chart.room", "a chart of {width} × {height} pixels leaves too little room for the data next to labels and "
                        "legend. Hint: choose a larger size"},
    {"view.inset.outside_picture", "inset lies outside of what the picture shows. Hint: choose a part of the bodies"},
    {"view.inset.room_each", "the picture is too small for an inset in each state. Hint: choose a larger size or fewer "
                             "columns, or crop = … for a picture of its own"},
    {"view.inset.room_or_crop",
     "the picture is too small for an inset. Hint: choose a larger size, or crop = … for a picture of its own"},
    {"view.inset.room", "the picture is too small for an inset. Hint: choose a larger size"},
    {"view.colors.outliers", "the colors of '{title}' leave out {count} of {samples} samples, which reach from {low:6} "
                             "to {high:6}. Hint: range = {{low, high}} sets the colors"},
    {"view.colors.range", "range must be two finite numbers, the lower one first, got {{{low}, {high}}}"},
    {"view.colormap.unknown", "colormap must be one of {known}, got '{colormap}'"},
    {"view.axis.range", "range of {axis} must be finite numbers, the lower one first, got {low} to {high}"},
    {"view.axis.range_log",
     "range of {axis} must be finite numbers above 0 on a logarithmic axis, the lower one first, got {low} to {high}"},
    {"view.file.ending", "file '{file}' of a figure must end in .png, .svg or .pdf"},
    {"view.frame.size",
     "size must lie between 160 × 120 and 5000 × 5000 pixels, got {width} × {height}. Hint: such as {{1600, 1000}}"},
    {"view.heatmap.category",
     "{map}values[{row:+1}][{column:+1}] must be the index of one of {count} categories, got {value}"},
    {"view.heatmap.log", "{map}values[{row:+1}][{column:+1}] must be above 0 on a logarithmic scale, got {value}. "
                         "Hint: leave log out, or blank such cells with nan"},
    {"view.heatmap.map", "map {number:+1},"},
    {"view.heatmap.empty", "a heat map needs values, got none"},
    {"view.heatmap.cells", "a heat map needs at least one x and one y, got {columns} and {rows}"},
    {"view.heatmap.values", "{map}values must be {rows:row}, one per y, of {columns:value}, one per x, got "
                            "{value_rows:row} of {value_columns}"},
    {"view.heatmap.texts", "{map}texts must match the cells, {rows:row} of {columns}"},
    {"view.heatmap.blank", "the map's cells are all blank; nothing can be drawn"},
    {"view.heatmap.columns", "columns must be at least 1, got {columns}"},
    {"view.heatmap.range", "range must begin above 0 on a logarithmic scale, got {low}"},
    {"view.heatmap.width", "a map of {width} × {height} pixels leaves too little room for its cells next to names and "
                           "legend. Hint: choose a larger size"},
    {"view.heatmap.height", "a map of {width} × {height} pixels leaves too little room for its cells above names and "
                            "labels. Hint: choose a larger size"},
    {"view.inset.no_curve",
     "inset: no curve runs between x = {low} and {high}. Hint: choose an xrange that holds data"},
    {"view.inset.outside_chart",
     "inset lies outside the chart's axes. Hint: choose a region within xrange and yrange of the chart"},
    {"view.legend.room", "the legend of {rows:row} does not fit a chart of {width} × {height} pixels. Hint: choose a "
                         "larger size, fewer labels, or legend = false"},
    {"view.module.missing", "pictures need {module}, which is neither in {first} nor in {second}. Hint: build it or "
                            "install the program as a whole"},
    {"view.module.load", "{file} cannot be loaded for pictures: {reason}"},
    {"view.module.foreign", "{file} is not Signorini's. Hint: install the program as a whole"},
    {"view.body.points", "{body} has coordinates that are not finite; nothing can be drawn"},
    {"view.body.lines", "{body} has a line with coordinates that are not finite; nothing can be drawn"},
    {"view.body.triangles", "{body} has triangles that name points outside 0 … {most}"},
    {"view.body.values", "{body} must have one value per point or none, got {values:value} for {points:point}"},
    {"view.body.field",
     "{body} has field values that are not finite. Hint: solve the state first, or choose another field"},
    {"view.body.net", "{body} has a net line that names control points outside 0 … {most}"},
    {"view.sheet.empty", "a sheet needs at least one state, got none"},
    {"view.sheet.obstacle", "{state}an obstacle has coordinates that are not finite"},
    {"view.sheet.mark", "{state}the mark '{mark}' stands at a place that is not finite"},
    {"view.sheet.state", "state {number:+1},"},
    {"view.sheet.body", "{state}body {number:+1}"},
    {"view.picture.empty", "a picture needs at least one body with points, got none"},
    {"view.picture.box", "{argument} must be {{xmin, xmax, ymin, ymax}} with min below max, got {box:list}"},
    {"view.picture.outside",
     "{argument} = {box:list} shows nothing: all that is drawn lies in x = {x:range}, y = {y:range}"},
    {"view.film.theora", "file '{file}' needs a VTK with Theora, and this one was built without. Hint: write an .mp4 "
                         "film by ffmpeg, or a series of pictures, file = \"x-%04d.png\""},
    {"view.series.number", "file '{file}' of a series must hold one number, as in \"x-%04d.png\""},
    {"view.series.no_folder", "cannot write '{file}': the folder '{folder}' does not exist. Hint: create it first"},
    {"view.series.folder",
     "cannot make a folder for the pictures of '{file}' next to it. Hint: choose a folder that can be written to"},
    {"view.film.rate", "fps must be a whole number from 1 to 5000 for a film in Ogg Theora, got {rate}"},
    {"view.film.ffmpeg", "file '{file}' needs the program ffmpeg, which is not in PATH. Hint: install it, or write a "
                         "film without it, file = \"x.ogv\", or a series of pictures, file = \"x-%04d.png\""},
    {"view.film.failed", "film '{file}' could not be made (file = \"x.ogv\" makes one without ffmpeg): {reason}"},
    {"view.sheet.room", "a picture of {width} × {height} pixels leaves too little room next to labels and color bar. "
                        "Hint: choose a larger size"},
    {"view.sheet.columns", "columns must be at least 1, got {columns}"},
    {"view.pictures.room", "{count:picture} find no room side by side on {width} × {height} pixels: {reason}"},
    {"view.pictures.larger", "choose a larger size"},
    {"view.mirror.across",
     "mirror: a body reaches across the mirror, from {axis} = {low:6} to {high:6}: of its smaller "
     "side only the image of the other one is drawn"},
    {"view.contours.none", "contours must hold a value of the field, which lies between {low} and {high}"},
    {"view.body.normals", "{body} must have one normal per point, got {normals:normal} for {points:point}"},
    {"view.body.inside", "{body} has lines or insides that are not finite; nothing can be drawn"},
    {"view.sheet.cut", "{state}a cut needs a finite point and a normal that is not zero"},
    {"view.solids.region",
     "{argument} must be {{xmin, xmax, ymin, ymax, zmin, zmax}} with min below max, got {box:list}"},
    {"view.solids.outside",
     "{argument} = {box:list} shows nothing: the bodies lie in x = {x:range}, y = {y:range}, z = {z:range}"},
    {"view.solids.idle_cut",
     "cut takes nothing away: the bodies lie in x = {x:range}, y = {y:range}, z = {z:range}, none of them on the side "
     "that its normal points to. Hint: move its plane, or reverse its normal"},
    {"view.solids.cut_away", "the cut takes all bodies away. Hint: move its plane, or reverse its normal"},
    {"view.ticks.bounds",
     "what is drawn must lie within ±1e300 and spread over 1e-300 at least. Hint: choose other units"},
    {"view.ticks.decades", "what is drawn on a logarithmic scale must spread over 300 decades at most"},
    {"view.film.transparent", "a film has an opaque background. Hint: leave transparent out"},
    {"view.film.sizes",
     "the pictures of a film must be of one size, got {width} × {height} and {next_width} × {next_height}"},
    {"view.film.write", "VTK could not write a film to '{file}'"},
    {"view.opengl.image", "OpenGL did not draw a picture of {width} × {height} pixels. Hint: choose a smaller size"},
    {"view.opengl.context", "no off-screen OpenGL context is available. Hint: install Mesa's libOSMesa 17 or newer"},
    {"exchange.vtu.directions", "a cell has 1 to 3 parametric directions, got {count}"},
    {"exchange.vtu.points", "the cells have {cell_points:point}, the grid {grid_points}"},
    {"view.text.no_font", "no installed font shows {characters:quoted} of the text '{text}'; boxes stand in the place. "
                          "Hint: apt install {packages: }, or use other words"},
    {"view.text.encoding", "the text '{text}' is not UTF-8: replacement characters stand in the place of what cannot "
                           "be read. Hint: save the script as UTF-8"},
};

} // namespace

std::span<const Wording> view_wordings() {
  return view_rows;
}

} // namespace signorini::bind
