// The example twice, once with a criterion that its vehicle cannot meet.
def copyInto = evaluate(new File(basedir, "../../../src/it/copies.groovy"))
for (copied in ["sound", "broken"]) {
  copyInto(new File(basedir, copied).toPath())
}
def scenario = new File(basedir, "broken/scenarios/short-sight.yaml")
assert scenario.text.contains("ego.speed <= 12 km/h")
scenario.text = scenario.text.replace("ego.speed <= 12 km/h", "ego.speed >= 200 km/h")
return true
