# Prints the measures and the most loaded rope of a state: python3 read_json.py trawl.json
import json
import sys

with open(sys.argv[1], encoding="utf-8") as file:
    state = json.load(file)
print(state["name"], state["conditions"], sep=", ")
for name, measure in state["measures"].items():
    print(name, measure["value"], measure["error"], measure["unit"])

values = {name: variable["values"] for name, variable in state["variables"].items()}
tension = values["bar_tension_N"]
bar = tension.index(max(tension))
node = values["bar_node"][bar][0] - 1  # numbers in the file start at 1
part = values["part"][values["bar_part"][bar] - 1]
print("most_loaded", part, tension[bar], *(values[axis][node] for axis in ("x_m", "y_m", "z_m")))
