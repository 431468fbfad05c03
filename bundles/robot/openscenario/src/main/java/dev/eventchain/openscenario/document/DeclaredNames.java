package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.XmlElement;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/** The names that a scenario declares for its run: parameters, variables and monitors. */
final class DeclaredNames {

  /** The elements that say what happens to a parameter, not which value it has. */
  private static final Set<String> OF_A_RUN = Set.of("ParameterAction", "ParameterCondition");

  private final Set<String> parameters = new LinkedHashSet<>();
  private final Set<String> variables = new LinkedHashSet<>();
  private final Set<String> monitors = new LinkedHashSet<>();
  private final Findings findings;

  DeclaredNames(ScenarioFile file, Findings findings) {
    this.findings = findings;
    file.parameters().forEach(each -> parameters.add(each.name()));
    file.variables().forEach(each -> variables.add(each.name()));
    file.element()
        .child("MonitorDeclarations")
        .ifPresent(
            all -> all.children().forEach(each -> each.attribute("name").ifPresent(monitors::add)));
  }

  /** Checks the names that an element refers to. */
  void check(XmlElement element, Map<String, String> values) {
    if (OF_A_RUN.contains(element.name())) {
      check(element, "parameterRef", "parameter", values, parameters);
    }
    check(element, "variableRef", "variable", values, variables);
    check(element, "monitorRef", "monitor", values, monitors);
  }

  private void check(
      XmlElement element,
      String attribute,
      String kind,
      Map<String, String> values,
      Set<String> known) {
    String name = values.get(attribute);
    // CARLA's scenarios have conditions on no parameter, which name its criteria and never hold.
    if (name != null && !name.isEmpty() && !known.contains(name)) {
      findings.add(
          DocumentRules.PARAMETER_UNKNOWN,
          "No " + kind + " `" + name + "` is declared.",
          element.location(attribute),
          NearestName.hint(name, known));
    }
  }
}
