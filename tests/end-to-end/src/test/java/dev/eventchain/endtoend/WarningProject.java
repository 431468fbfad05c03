package dev.eventchain.endtoend;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;

/** A small project for {@code mutate}: its component of a warning has seven mutants. */
record WarningProject(ProjectCopy copy) {

  static final String NAME = "Collision_Warning";
  static final String COMPONENT = "software-base/components/" + NAME + ".py";

  /** Tests that notice each mutant: at the limit, below it, and after a warning. */
  static final String TESTS =
      """
      tests:
        - {name: at the limit, requirement: RAD-2, inputs: {ttc: 2.6}, outputs: {warns: false}}
        - {name: just below, requirement: RAD-2, inputs: {ttc: 2.59}, outputs: {warns: true}}
        - {name: afterwards, requirement: RAD-2, steps: [{inputs: {ttc: 1}}, {inputs: {ttc: 3}}],
           outputs: {warns: false}}
      """;

  static final String SIGN = "sign in execute, -1000000000000 -> 1000000000000";

  static WarningProject below(Path folder) throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.onlyScenario("scenarios/stopped-vehicle-50.yaml");
    copy.endAtEightSeconds();
    return new WarningProject(copy);
  }

  /** Tries the mutants of the component. */
  Program.Ended mutate(Object... more) {
    Object[] arguments = new Object[more.length + 4];
    arguments[0] = "mutate";
    arguments[1] = copy.path();
    arguments[2] = "--component";
    arguments[3] = NAME;
    System.arraycopy(more, 0, arguments, 4, more.length);
    return new Program().run(arguments);
  }

  JsonNode results() throws IOException {
    return new ObjectMapper()
        .readTree(copy.path().resolve("out/mutants.json").toFile())
        .path("mutants");
  }

  Set<String> outcomes() throws IOException {
    return outcomes(NAME);
  }

  Set<String> outcomes(String component) throws IOException {
    Set<String> outcomes = new TreeSet<>();
    for (JsonNode mutant : results()) {
      if (mutant.path("component").asText().equals(component)) {
        outcomes.add(mutant.path("outcome").asText());
      }
    }
    return outcomes;
  }

  /** Hosts the node of the warning as it is, instead of the component. */
  void hostTheNode() throws IOException {
    copy.replace(
        "software-base/components.json",
        "\"name\": \"" + NAME + "\",",
        "\"name\": \""
            + NAME
            + "\", \"implementation\": \"node\", \"file\": \"nodes/warning.py\","
            + " \"node\": {\"class\": \"Warning\"},");
    copy.replace(
        "model/chain.xmi",
        "name=\"" + NAME + "\"",
        "name=\"" + NAME + "\" implementation=\"NODE\"");
  }
}
