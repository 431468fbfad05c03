package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;

/** Reads the expressions of conditions. */
final class Tests {

  private Tests() {}

  static Test read(ScenarioElement condition, ElementPaths elements) {
    ScenarioElement kind = condition.choice();
    return kind.name().equals("ByEntityCondition")
        ? EntityTests.read(kind)
        : ValueTests.read(kind.choice(), elements);
  }
}
