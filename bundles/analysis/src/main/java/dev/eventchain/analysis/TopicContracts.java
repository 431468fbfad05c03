package dev.eventchain.analysis;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.RosNames;
import dev.eventchain.metamodel.DataFlowIndex;
import dev.eventchain.metamodel.Signal;
import dev.eventchain.metamodel.eventchain.Data;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;

/** Whether each topic has one type, someone who writes it and someone who reads it. */
final class TopicContracts {

  private final boolean vehicleKnown;
  private final Collection<String> signals;
  private final DataFlowIndex flow;
  private final TypeContracts types;
  private final Findings findings;
  private final Set<String> written = new TreeSet<>();
  private final Set<String> read = new TreeSet<>();

  /**
   * Prepares the checks.
   *
   * @param signals the topics that the vehicle's description names; empty if there is none, so that
   *     nobody knows what comes from outside of the chain
   */
  TopicContracts(
      List<Topic> topics,
      Optional<? extends Collection<String>> signals,
      DataFlowIndex flow,
      TypeContracts types,
      Findings findings) {
    this.vehicleKnown = signals.isPresent();
    this.signals = signals.isPresent() ? signals.get() : List.of();
    this.flow = flow;
    this.types = types;
    this.findings = findings;
    for (Topic topic : topics) {
      boolean provided = topic.is(Signal.Direction.PROVIDED);
      boolean consumed = topic.is(Signal.Direction.CONSUMED);
      if (provided || !topic.publishers().isEmpty()) {
        written.add(topic.name());
      }
      if (consumed || !topic.subscribers().isEmpty()) {
        read.add(topic.name());
      }
    }
  }

  void check(Topic topic) {
    oneType(topic);
    onePublisher(topic);
    if (vehicleKnown) {
      topic.subscribers().forEach(subscriber -> isFed(topic, subscriber));
      topic.publishers().forEach(publisher -> isRead(topic, publisher));
    }
    topic.subscribers().forEach(subscriber -> fieldsAreSet(topic, subscriber));
  }

  /** Against the signal where there is one, else against whoever comes first. */
  private void oneType(Topic topic) {
    Rule rule = topic.signal().isPresent() ? Rule.SIGNAL_TYPE : Rule.TOPIC_TYPE;
    String wanted = topic.signal().map(Signal::messageType).orElse("");
    Supplier<SourceLocation> other = () -> topic.signal().orElseThrow().location();
    String owner = topic.signal().isPresent() ? "signals.json" : "";
    for (Endpoint endpoint : topic.endpoints()) {
      Set<String> seen = new HashSet<>();
      for (Data data : endpoint.data()) {
        if (!TypeContracts.isQualified(data.getMessageType()) || !seen.add(data.getMessageType())) {
          continue;
        }
        if (wanted.isEmpty()) {
          wanted = data.getMessageType();
          owner = endpoint.name();
          other = () -> findings.at(data);
          continue;
        }
        findings.checked(rule);
        if (!same(wanted, data.getMessageType())) {
          findings.error(
              rule,
              findings.at(data),
              "%s takes the messages of %s for %s, but %s has %s."
                  .formatted(endpoint.name(), topic.name(), data.getMessageType(), owner, wanted),
              "A topic has one type: write %s, or use another topic.".formatted(wanted),
              other.get());
        }
      }
    }
  }

  private static boolean same(String first, String second) {
    return RosNames.fullMessageType(first).equals(RosNames.fullMessageType(second));
  }

  private static boolean sameKnown(String first, String second) {
    return first != null && second != null && same(first, second);
  }

  private void onePublisher(Topic topic) {
    if (topic.publishers().isEmpty()) {
      return;
    }
    findings.checked(Rule.PUBLISHERS_SEVERAL);
    Endpoint first = topic.publishers().get(0);
    for (Endpoint publisher : topic.publishers().subList(1, topic.publishers().size())) {
      findings.warning(
          Rule.PUBLISHERS_SEVERAL,
          findings.at(publisher.first()),
          "%s writes %s, which %s writes too."
              .formatted(publisher.name(), topic.name(), first.name()),
          "Readers get the messages of both mixed: give one of them another topic, unless that is"
              + " meant.",
          findings.at(first.first()));
    }
  }

  private void isFed(Topic topic, Endpoint subscriber) {
    findings.checked(Rule.PUBLISHER_MISSING);
    if (!written.contains(topic.name())) {
      String vehicle =
          topic
              .signal()
              .map(signal -> "signals.json has it as " + word(signal) + ", not as provided")
              .orElse("signals.json has no such signal");
      findings.error(
          Rule.PUBLISHER_MISSING,
          findings.at(subscriber.first()),
          "%s reads %s, but no component of the chain writes it, and %s."
              .formatted(subscriber.name(), topic.name(), vehicle),
          hint(
              topic.name(),
              written,
              "add the component that writes it, or describe it in signals.json with the direction"
                  + " provided."),
          place(topic));
    }
  }

  private void isRead(Topic topic, Endpoint publisher) {
    findings.checked(Rule.CONSUMER_MISSING);
    if (!read.contains(topic.name())) {
      String vehicle =
          topic
              .signal()
              .map(signal -> "signals.json has it as " + word(signal) + ", not as consumed")
              .orElse("signals.json has no such signal");
      findings.error(
          Rule.CONSUMER_MISSING,
          findings.at(publisher.first()),
          "%s writes %s, but no component of the chain reads it, and %s."
              .formatted(publisher.name(), topic.name(), vehicle),
          hint(
              topic.name(),
              read,
              "leave the output out, or describe it in signals.json with the direction"
                  + " consumed."),
          place(topic));
    }
  }

  /** The topic that may have been meant: one that somebody uses, or at least knows. */
  private String hint(String topic, Set<String> used, String otherwise) {
    Set<String> known = new TreeSet<>(used);
    known.addAll(signals);
    known.remove(topic);
    Optional<String> nearest = NearestName.of(topic, known);
    return nearest.map(name -> "Did you mean `" + name + "`? Else ").orElse("")
        + (nearest.isPresent()
            ? otherwise
            : Character.toUpperCase(otherwise.charAt(0)) + otherwise.substring(1));
  }

  private static String word(Signal signal) {
    return signal.direction().name().toLowerCase(Locale.ROOT);
  }

  private static SourceLocation place(Topic topic) {
    return topic.signal().map(Signal::location).orElse(SourceLocation.NONE);
  }

  /** A field that nobody sets is zero, empty or false in every message. */
  private void fieldsAreSet(Topic topic, Endpoint subscriber) {
    if (topic.publishers().isEmpty() || topic.is(Signal.Direction.PROVIDED)) {
      return;
    }
    for (Data data : subscriber.data()) {
      boolean sameType =
          topic.publishers().stream()
              .flatMap(publisher -> publisher.data().stream())
              .anyMatch(output -> sameKnown(output.getMessageType(), data.getMessageType()));
      if (sameType && types.fieldType(data).isPresent()) {
        findings.checked(Rule.FIELD_UNSET);
        if (flow.producers(data).isEmpty()) {
          Endpoint publisher = topic.publishers().get(0);
          Set<String> set = fieldsThatAreSet(topic, data.getMessageType());
          findings.error(
              Rule.FIELD_UNSET,
              findings.at(data),
              "%s reads the field '%s' of %s, which %s does not set."
                  .formatted(
                      subscriber.name(), data.getFieldName(), topic.name(), publisher.name()),
              set.isEmpty()
                  ? "Set it, or read it nowhere."
                  : "Set are %s: read one of them, or set this one too."
                      .formatted(String.join(", ", set)),
              findings.at(publisher.first()));
        }
      }
    }
  }

  private static Set<String> fieldsThatAreSet(Topic topic, String messageType) {
    Set<String> set = new TreeSet<>();
    topic.publishers().stream()
        .flatMap(publisher -> publisher.data().stream())
        .filter(output -> output.getFieldName() != null)
        .filter(output -> sameKnown(output.getMessageType(), messageType))
        .forEach(output -> set.add(output.getFieldName()));
    return set;
  }
}
