def copyInto = evaluate(new File(basedir, "../../../src/it/copies.groovy"))
copyInto(new File(basedir, "radar-aeb").toPath())
return true
