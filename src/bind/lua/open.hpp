#pragma once
// The contributions of the binding files, all called by library.cpp.

#include <lua.hpp>

namespace signorini::bind {

void open_core(lua_State* L);       ///< core.*: C++ functions for the library in lua/; sg.mkdir, sg.wall_time
void open_algebra(lua_State* L);    ///< core.singular_values, core.box_least_squares
void open_curves(lua_State* L);     ///< sg.nurbs.*
void open_shapes(lua_State* L);     ///< sg.shapes.*
void open_patch(lua_State* L);      ///< the patch type and its methods, sg.nurbs.read, sg.nurbs.write
void open_symbols(lua_State* L);    ///< symbols, sg.log and other functions of numbers and symbols
void open_material(lua_State* L);   ///< sg.neo_hookean, sg.linear_elastic, the material type
void open_body(lua_State* L);       ///< sg.body, bodies, their faces, edges and corners
void open_rigid(lua_State* L);      ///< sg.rigid.*
void open_scene(lua_State* L);      ///< sg.model
void open_model(lua_State* L);      ///< the model type, methods for its parts and about its cost, snapshots
void open_path(lua_State* L);       ///< its methods for the load path and for Newton's method
void open_changes(lua_State* L);    ///< model:set_contact and its checks
void open_modes(lua_State* L);      ///< core.modes
void open_results(lua_State* L);    ///< its methods for the present state
void open_checkpoint(lua_State* L); ///< sg.load, core.save, core.content and others
void open_adaptation(lua_State* L); ///< core.follow and others: layers that follow the contact
void open_chart(lua_State* L);      ///< sg.chart
void open_picture(lua_State* L);    ///< sg.picture
void open_screen(lua_State* L);     ///< core.show_picture and others: pictures on the terminal
void open_heatmap(lua_State* L);    ///< sg.heatmap
void open_vtu(lua_State* L);        ///< sg.vtu
void open_hdf5(lua_State* L);       ///< core.make_result_file, core.open_result_file and others
void open_jobs(lua_State* L);       ///< core.jobs: parallel processes
void open_json(lua_State* L);       ///< core.write_json, core.pack and others

} // namespace signorini::bind
