# Made once, when the package is installed: of the files of plans this one is read last.
plan_schema <- compile_schema()
