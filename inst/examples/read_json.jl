# Prints the measures and the most loaded rope of a state: julia read_json.jl trawl.json
using JSON

state = JSON.parsefile(ARGS[1])
println(state["name"], ", ", state["conditions"])
for (name, measure) in state["measures"]
    println(join([name, measure["value"], measure["error"], measure["unit"]], " "))
end

values_of(name) = state["variables"][name]["values"]
tension, bar = findmax(values_of("bar_tension_N"))
node = values_of("bar_node")[bar][1]
part = values_of("part")[values_of("bar_part")[bar]]
place = [values_of(axis)[node] for axis in ("x_m", "y_m", "z_m")]
println(join(["most_loaded", part, tension, place...], " "))
