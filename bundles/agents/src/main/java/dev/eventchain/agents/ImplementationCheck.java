package dev.eventchain.agents;

import dev.eventchain.agents.ChainView.Component;
import dev.eventchain.agents.ChainView.Value;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.python.ComponentProbe;
import dev.eventchain.python.ComponentSignature;
import dev.eventchain.python.WorkFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Whether a Python module is the component that the chain describes, and stands its inputs at their
 * edges.
 */
final class ImplementationCheck {
  private final ComponentProbe probe;
  private final Component component;

  ImplementationCheck(ComponentProbe probe, Component component) {
    this.probe = probe;
    this.component = component;
  }

  List<Diagnostic> check(SourceText python) {
    ComponentSignature signature =
        new ComponentSignature(
            component.name(), names(component.inputValues()), names(component.outputValues()));
    try (WorkFolder folder = WorkFolder.create()) {
      Path file = folder.path().resolve("component.py");
      try {
        Files.writeString(file, python.text());
      } catch (IOException e) {
        throw folder.unwritable(e);
      }
      return probe.check(file, signature, ProbeCalls.of(component.inputValues())).stream()
          .map(finding -> finding.withLocation(renamed(finding.location(), python.name())))
          .toList();
    }
  }

  private static List<String> names(List<Value> values) {
    return values.stream().map(Value::name).toList();
  }

  private static SourceLocation renamed(SourceLocation place, String file) {
    return new SourceLocation(file, place.line(), place.column(), place.element(), place.excerpt());
  }
}
