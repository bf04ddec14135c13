# Prints the measures and the most loaded rope of a state: python3 read_netcdf.py trawl.nc
import sys
import xarray

state = xarray.open_dataset(sys.argv[1])
print(state.attrs["title"])
for name, measure in state.items():
    if "error" in measure.attrs:
        print(name, measure.item(), measure.attrs["error"], measure.attrs["units"])

bar = int(state["bar_tension_N"].argmax())
node = int(state["bar_node"][bar, 0]) - 1  # numbers in the file start at 1
part = state["part"].values[int(state["bar_part"][bar]) - 1]
place = [state[axis].item(node) for axis in ("x_m", "y_m", "z_m")]
print("most_loaded", part, state["bar_tension_N"].item(bar), *place)
