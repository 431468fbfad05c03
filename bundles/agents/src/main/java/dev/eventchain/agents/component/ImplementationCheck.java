package dev.eventchain.agents.component;

import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.Signal;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.sandbox.WorkFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Checks that a Python module is the component that the chain describes, and handles inputs at
 * their limits.
 */
public final class ImplementationCheck {
  private final ComponentProbe probe;
  private final Component component;
  private final Optional<ComponentTester> tests;
  private final List<Signal> signals;
  private final ProbeMessages messages;

  /**
   * Creates a check.
   *
   * @param tests the tests of the component, if it has any
   * @param signals the vehicle's signals, at whose limits the component is called, too
   * @param messages gives the message types, of which inputs may be
   */
  public ImplementationCheck(
      ComponentProbe probe,
      Component component,
      Optional<ComponentTester> tests,
      List<Signal> signals,
      Supplier<MessageCatalog> messages) {
    this.messages = new ProbeMessages(messages);
    this.probe = probe;
    this.component = component;
    this.tests = tests;
    this.signals = List.copyOf(signals);
  }

  public List<Diagnostic> check(SourceText python) {
    try (WorkFolder folder = WorkFolder.create()) {
      Path file = folder.path().resolve("component.py");
      try {
        Files.writeString(file, python.text());
      } catch (IOException e) {
        throw folder.unwritable(e);
      }
      List<Diagnostic> found =
          probe.check(
              file,
              component.signature(),
              ProbeCalls.of(
                  component.inputValues(), SignalLimits.of(component, signals), messages));
      if (found.isEmpty()) {
        found = tests.map(each -> each.run(probe, file)).orElse(List.of());
      }
      return found.stream()
          .map(finding -> finding.withLocation(renamed(finding.location(), python.name())))
          .toList();
    }
  }

  /** Moves a place to another file name, except for places in tests. */
  private SourceLocation renamed(SourceLocation place, String file) {
    return tests.isPresent() && tests.get().holds(place)
        ? place
        : new SourceLocation(file, place.line(), place.column(), place.element(), place.excerpt());
  }
}
