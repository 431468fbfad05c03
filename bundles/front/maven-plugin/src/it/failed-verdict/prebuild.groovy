// The example, with a criterion that its vehicle cannot meet.
def copyInto = evaluate(new File(basedir, "../../../src/it/copies.groovy"))
copyInto(basedir.toPath())
def scenario = new File(basedir, "scenarios/short-sight.yaml")
def text = scenario.text
assert text.contains("ego.speed <= 12 km/h")
scenario.text = text.replace("ego.speed <= 12 km/h", "ego.speed >= 200 km/h")
return true
