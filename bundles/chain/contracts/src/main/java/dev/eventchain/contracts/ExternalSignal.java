package dev.eventchain.contracts;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.Requirement;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;

/**
 * Check of signals that are declared to leave the chain. A requirement must ask for each, and its
 * topic must not be a misspelt name of another signal.
 */
final class ExternalSignal {

  private final Topic topic;
  private final Endpoint publisher;
  private final Findings findings;

  ExternalSignal(Topic topic, Endpoint publisher, Findings findings) {
    this.topic = topic;
    this.publisher = publisher;
    this.findings = findings;
  }

  /**
   * Checks the declaration.
   *
   * @param awaited the topics that the vehicle consumes and no component of the chain writes
   */
  void check(Set<String> awaited) {
    Optional<Signal> signal = topic.signal();
    if (signal.isPresent() && signal.get().direction() == Signal.Direction.INTERNAL) {
      report(
          "but the existing signal of this name is internal",
          "Give the signal that leaves the chain a topic of its own.",
          signal.get().location());
    } else if (signal.isEmpty()) {
      NearestName.of(topic.name(), awaited).ifPresent(this::misspelt);
    }
    requirements();
  }

  private void misspelt(String meant) {
    report(
        "but the vehicle awaits %s, which no component writes".formatted(meant),
        "Did you mean `%s`? Otherwise, give the signal a name that resembles it less."
            .formatted(meant));
  }

  private void requirements() {
    Set<Requirement> asking = new LinkedHashSet<>();
    publisher.data().stream().map(Data::getSatisfies).forEach(asking::addAll);
    if (asking.isEmpty()) {
      report(
          "but names no requirement that asks for it",
          "Name the requirement with the output, or leave the output out.");
    }
    asking.removeAll(publisher.node().getSatisfies());
    for (Requirement other : asking) {
      report(
          "as %s asks, but does not itself contribute to %s"
              .formatted(other.getId(), other.getId()),
          "Name %s with the component, too.".formatted(other.getId()));
    }
  }

  private void report(String problem, String hint, SourceLocation... related) {
    findings.error(
        ContractRule.CONSUMER_MISSING,
        findings.at(publisher.first(), Literals.DATA__TOPIC_NAME),
        "%s writes %s for a consumer outside of the chain, %s."
            .formatted(publisher.name(), topic.name(), problem),
        hint,
        related);
  }
}
