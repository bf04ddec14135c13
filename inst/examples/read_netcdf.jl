# Prints the measures and the most loaded rope of a state: julia read_netcdf.jl trawl.nc
using NCDatasets

state = NCDataset(ARGS[1])
println(state.attrib["title"])
for (name, measure) in state
    if haskey(measure.attrib, "error")
        println(join([name, measure[], measure.attrib["error"], measure.attrib["units"]], " "))
    end
end

tension, bar = findmax(state["bar_tension_N"][:])
node = state["bar_node"][1, bar]
parts = [rstrip(String(name), '\0') for name in eachcol(state["part"][:, :])]
place = [state[axis][node] for axis in ("x_m", "y_m", "z_m")]
println(join(["most_loaded", parts[state["bar_part"][bar]], tension, place...], " "))
