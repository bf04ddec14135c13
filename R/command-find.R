run_find <- function(plan, options) {
  check_plan_out(options$out)
  check_place(options$json, "--json")
  change <- option_ranges(options$change)
  target <- named_parts(options$target, "--target", ".+", "MEASURE = VALUE", plan_value)
  gear <- read_changed(plan, options)
  found <- do.call(find_value, c(list(gear), change, list(target = target),
    settle_arguments(options)))
  if (!identical(options$json, "-")) print(found)
  if (!is.null(options$json)) write_json(found_record(plan, found), options$json)
  write_found(found$gear, options$out)
}

# Returns the JSON record of found values: the tables of fields and targets.
found_record <- function(plan, found) {
  list(
    plan = plan, reached = all(found$targets$reached), n_solves = found$n_solves,
    nodes = found$state$mesh$nodes, fields = row_records(found$fields),
    targets = row_records(found$targets)
  )
}
