test_that("a net is unchanged after writing and reading its table", {
  file <- withr::local_tempfile(fileext = ".csv")
  trawl <- two_seam()
  write_gear(trawl, file)
  expect_identical(names(utils::read.csv(file))[1:4], c("panel", "row", "pair", "mesh_size"))
  again <- update(trawl, net = read_net(file))
  expect_equal(gear_si(again)$panels, gear_si(trawl)$panels)
  other <- update(trawl, net.lower.codend.covers = list(chafer = list(mesh_size = "120 mm",
    meshes = list(upper = 40, lower = 40, deep = 40), twine = list(diameter = "4 mm",
      material = "PE"))), net.upper.body_2.knotted = FALSE)
  write_gear(other, file)
  expect_equal(gear_si(update(trawl, net = read_net(file)))$panels, gear_si(other)$panels)
})

test_that("a pasted sheet with units in its header reads as a net", {
  sheet <- paste(
    "Panel\tRow\tPair\tMesh size (mm)\ttwine_mm\tMaterial\tFront\tDeep\tInner\tOuter\tCutting",
    "upper\twing_1\tyes\t160\t3\tPE\t25\t40\tAB\t1N2B\t",
    "upper\tbody\t\t140\t2,5\tPE\t190\t60\t\t\t1N2B", sep = "\r\n"
  )
  expect_identical(read_net(sheet)$upper, list(
    wing_1 = list(pair = TRUE, mesh_size = "160 mm", twine = list(diameter = "3 mm",
      material = "PE"), meshes = list(front = 25, deep = 40),
    cutting = list(inner = "AB", outer = "1N2B")),
    body = list(mesh_size = "140 mm", twine = list(diameter = "2.5 mm", material = "PE"),
      meshes = list(front = 190, deep = 60), cutting = "1N2B")
  ))
  expect_error(read_net("panel,front\nupper,20"), "no column")
  expect_error(read_net("panel,row\nupper,a\nupper,a"), "two rows")
  expect_error(write_gear(read_gear("pair_trawl"), "x.csv"), "only = ")
})

test_that("a sheet of 13 rows with other names and decimal commas settles", {
  sheet <- "Panel;Row;Pair;Mesh (mm);Twine (mm);Material;Double;Front;Deep;Inner;Outer;Cutting
    Upper;Wing 1;yes;160;4,0;PE;;22;45,5;AB;1N2B;
    ;Wing 2;yes;140;3,0;PE;;52;48;AB;1N2B;
    ;Square;;140;3;PE;;230;32;;;1N2B
    ;Body 1;;140;3;PE;;198;50;;;1N2B
    ;Body 2;;100;2,5;PE;;205;80;;;1N2B
    ;Extension;;80;2,5;PE;;156;100;;;5N2B
    ;Codend;;80;3;PE;yes;122;75;;;AN
    Lower;Lower wing 1;yes;160;4;PE;;25;50;1N4B;1N2B;
    ;Lower wing 2;yes;140;4;PE;;40;74;1N4B;1N2B;
    ;Body 1;;140;4;PE;;198;50;;;1N2B
    ;Body 2;;100;4;PE;;205;80;;;1N2B
    ;Extension;;80;3;PE;;156;100;;;5N2B
    ;Codend;;80;3;PE;yes;122;75;;;AN"
  trawl <- update(two_seam(), net = read_net(sheet))
  wing <- gear_si(trawl)$panels$back_Wing_1_left
  # 45.5 rows lose half a mesh each at the outer edge and gain one each at the inner edge
  expect_equal(c(wing$mesh_size, wing$twine_diameter, wing$lower), c(0.16, 0.004, 22 + 45.5 / 2))
  expect_equal(gear_si(trawl)$panels$belly_Body_1$twine_diameter, 0.004)
  expect_no_error(settle(trawl, nodes = 300))
})

test_that("the net of a plan may be a table in its folder", {
  folder <- withr::local_tempdir()
  trawl <- two_seam()
  write_gear(trawl, file.path(folder, "my_net.csv"))
  text <- readLines(system.file("extdata", "two_seam_trawl.yaml", package = "codend"))
  plan <- file.path(folder, "plan.yaml")
  text <- text[seq_len(grep("^net:", text) - 1L)]
  writeLines(c(text, "net: my_net.csv  # from the drawing"), plan)
  read <- read_gear(plan)
  expect_equal(gear_si(read)$panels, gear_si(trawl)$panels)
  # a written plan holds the net itself
  copy <- file.path(withr::local_tempdir(), "copy.yaml")
  write_gear(update(read, towing.speed = "2.5 knot"), copy)
  expect_equal(gear_si(read_gear(copy))$panels, gear_si(trawl)$panels)
  writeLines(sub("my_net", "no_net", readLines(plan)), plan)
  expect_refused(read_gear(plan), "no_net.csv\", a file that does not exist.*line")
  writeLines("row,front\nbody,20", file.path(folder, "no_net.csv"))
  expect_refused(read_gear(plan), "no_net.csv.*no column")
})
