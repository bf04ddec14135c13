# Made once, when the package is installed: of the files of plans this one is read last.
for (kind in names(compiled <- compile_schema())) {
  assign(paste0("plan_kind_", kind), compiled[[kind]])
}
plan_kinds <- names(compiled)
rm(kind, compiled)
