package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.AcceptedTexts;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Evidence for requirements whose text has changed since somebody looked at it. A project that
 * keeps no accepted texts has none.
 */
final class StaleEvidence {

  private StaleEvidence() {}

  /** Returns a finding for each requirement whose text is not the accepted one. */
  static List<Diagnostic> of(RunContext run) {
    Optional<AcceptedTexts> accepted = run.project().accepted();
    List<Diagnostic> found = new ArrayList<>();
    if (accepted.isPresent()) {
      run.writtenRequirements()
          .forEach(item -> stale(run, item, accepted.get()).ifPresent(found::add));
    }
    return found;
  }

  private static Optional<Diagnostic> stale(
      RunContext run, WrittenRequirement item, AcceptedTexts accepted) {
    Optional<AcceptedTexts.Entry> entry = accepted.find(item.id());
    if (entry.filter(e -> e.text().equals(AcceptedTexts.fingerprint(item.text()))).isPresent()) {
      return Optional.empty();
    }
    String text =
        entry
            .map(
                known ->
                    "The text of %s has changed since %s looked at its evidence on %s."
                        .formatted(item.id(), known.by(), known.on()))
            .orElse("Nobody has looked at the evidence for " + item.id() + " yet.");
    Diagnostic found =
        Diagnostic.of(SimulateRules.PROJECT_REQUIREMENT_STALE, text, item.location())
            .withRule(item.id())
            .withHint(
                "Read the scenarios and constraints that name it, then run 'eventchain accept "
                    + run.project().folder()
                    + " "
                    + item.id()
                    + "'.");
    return Optional.of(entry.map(known -> found.withRelated(known.location())).orElse(found));
  }

  /** Returns the ids of the requirements of findings. */
  static Set<String> ids(List<Diagnostic> stale) {
    return stale.stream().map(Diagnostic::rule).collect(Collectors.toSet());
  }
}
