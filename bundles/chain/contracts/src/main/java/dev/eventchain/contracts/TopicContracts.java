package dev.eventchain.contracts;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;

/** Checks that each topic has one type, a publisher and a subscriber. */
final class TopicContracts {

  private static final String LEAVES =
      "leave the output out; or, if a requirement asks for a signal that leaves the chain, say so"
          + " with the ";

  /** Declaration of an external output in descriptions. */
  private static final String LEAVES_IN_JSON =
      LEAVES
          + "output: \"consumer\": \"external\", and in \"requirements\" the ids of those that ask"
          + " for it.";

  /** Declaration of an external output in models. */
  private static final String LEAVES_IN_A_MODEL =
      LEAVES + "data: external=\"true\", and in satisfies the requirements that ask for it.";

  private final boolean vehicleKnown;
  private final Collection<String> signals;
  private final DataFlowIndex flow;
  private final TypeContracts types;
  private final Findings findings;
  private final Set<String> written = new TreeSet<>();
  private final Set<String> read = new TreeSet<>();

  /** Topics that the vehicle consumes and no component of the chain writes. */
  private final Set<String> awaited = new TreeSet<>();

  /**
   * Prepares the checks.
   *
   * @param signals the vehicle's signals by topic; empty without a description, so that publishers
   *     and subscribers outside the chain are unknown
   */
  TopicContracts(
      List<Topic> topics,
      Optional<Map<String, Signal>> signals,
      DataFlowIndex flow,
      TypeContracts types,
      Findings findings) {
    this.vehicleKnown = signals.isPresent();
    this.signals = signals.orElse(Map.of()).keySet();
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
    signals
        .orElse(Map.of())
        .forEach(
            (name, signal) -> {
              if (signal.direction() == Signal.Direction.CONSUMED && !written.contains(name)) {
                awaited.add(name);
              }
            });
  }

  void check(Topic topic) {
    oneType(topic);
    onePublisher(topic);
    if (vehicleKnown) {
      topic.subscribers().forEach(subscriber -> isFed(topic, subscriber));
      topic.publishers().forEach(publisher -> isRead(topic, publisher));
    }
    topic.subscribers().forEach(subscriber -> fieldsAreSet(topic, subscriber));
    topic.subscribers().forEach(subscriber -> staysInside(topic, subscriber));
  }

  /** Checks types against the signal if there is one, otherwise against the first endpoint. */
  private void oneType(Topic topic) {
    var rule = topic.signal().isPresent() ? ContractRule.SIGNAL_TYPE : ContractRule.TOPIC_TYPE;
    String wanted = topic.signal().map(Signal::messageType).orElse("");
    Supplier<SourceLocation> other = () -> topic.signal().orElseThrow().location();
    String owner = topic.signal().isPresent() ? "the existing signal" : "";
    for (Endpoint endpoint : topic.endpoints()) {
      Set<String> seen = new HashSet<>();
      for (Data data : endpoint.data()) {
        if (!TypeContracts.isQualified(data.getMessageType()) || !seen.add(data.getMessageType())) {
          continue;
        }
        if (wanted.isEmpty()) {
          wanted = data.getMessageType();
          owner = endpoint.name();
          other = () -> findings.at(data, Literals.DATA__MESSAGE_TYPE);
          continue;
        }
        findings.checked(rule);
        if (!same(wanted, data.getMessageType())) {
          findings.error(
              rule,
              findings.at(data, Literals.DATA__MESSAGE_TYPE),
              "%s declares %s as %s, but %s has %s."
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
    findings.checked(ContractRule.PUBLISHERS_SEVERAL);
    Endpoint first = topic.publishers().get(0);
    for (Endpoint publisher : topic.publishers().subList(1, topic.publishers().size())) {
      findings.warning(
          ContractRule.PUBLISHERS_SEVERAL,
          findings.at(publisher.first(), Literals.DATA__TOPIC_NAME),
          "%s writes %s, which %s also writes."
              .formatted(publisher.name(), topic.name(), first.name()),
          "Readers get the messages of both interleaved: give one of them another topic, unless"
              + " this is intended.",
          findings.at(first.first(), Literals.DATA__TOPIC_NAME));
    }
  }

  private void isFed(Topic topic, Endpoint subscriber) {
    findings.checked(ContractRule.PUBLISHER_MISSING);
    if (!written.contains(topic.name())) {
      SourceLocation place = findings.at(subscriber.first(), Literals.DATA__TOPIC_NAME);
      findings.error(
          ContractRule.PUBLISHER_MISSING,
          place,
          "%s reads %s, but no component of the chain writes it, and %s."
              .formatted(subscriber.name(), topic.name(), vehicle(topic, "provided")),
          hint(
              topic.name(),
              written,
              "read a topic that somebody writes, or add the component that writes this one"
                  + orDirection(topic, place, "; if the vehicle sends it, ", "provided")),
          place(topic));
    }
  }

  private void isRead(Topic topic, Endpoint publisher) {
    findings.checked(ContractRule.CONSUMER_MISSING);
    if (publisher.isExternal()) {
      new ExternalSignal(topic, publisher, findings).check(awaited);
    } else if (!read.contains(topic.name())) {
      SourceLocation place = findings.at(publisher.first(), Literals.DATA__TOPIC_NAME);
      String leaves = isDescription(place) ? LEAVES_IN_JSON : LEAVES_IN_A_MODEL;
      String out =
          "leave the output out"
              + orDirection(topic, place, "; if the vehicle takes it, ", "consumed");
      findings.error(
          ContractRule.CONSUMER_MISSING,
          place,
          "%s writes %s, but no component of the chain reads it, and %s."
              .formatted(publisher.name(), topic.name(), vehicle(topic, "consumed")),
          hint(topic.name(), read, topic.signal().isPresent() ? out : leaves),
          place(topic));
    }
  }

  /** Refuses external inputs: the declaration has no meaning there, and is missing at an output. */
  private void staysInside(Topic topic, Endpoint subscriber) {
    for (Data data : subscriber.data()) {
      findings.checked(ContractRule.EXTERNAL_INPUT);
      if (data.isExternal() || !data.getSatisfies().isEmpty()) {
        findings.error(
            ContractRule.EXTERNAL_INPUT,
            findings.at(data, Literals.DATA__EXTERNAL),
            "'%s', by which %s reads %s, is declared to leave the chain, but is an input."
                .formatted(data.getName(), subscriber.name(), topic.name()),
            "Leave external and satisfies out of inputs; declare the output that leaves the"
                + " chain.");
      }
    }
  }

  private static String vehicle(Topic topic, String wanted) {
    return topic
        .signal()
        .map(signal -> "the existing signal of this name is " + word(signal) + ", not " + wanted)
        .orElse("no existing signal has this name");
  }

  /**
   * Returns whether a location is in a description by a language model, which cannot change the
   * signals.
   */
  private static boolean isDescription(SourceLocation place) {
    return place.file().endsWith(".json");
  }

  /** Returns the end of a hint: for users, the missing direction of a signal. */
  private static String orDirection(
      Topic topic, SourceLocation place, String condition, String wanted) {
    return topic.is(Signal.Direction.INTERNAL) && !isDescription(place)
        ? condition + "say \"direction\": \"" + wanted + "\" in signals.json."
        : ".";
  }

  /** Returns a hint with a similar topic that is used or at least known. */
  private String hint(String topic, Set<String> used, String otherwise) {
    Set<String> known = new TreeSet<>(used);
    known.addAll(signals);
    String question = NearestName.question(topic, known);
    return question.isEmpty()
        ? Character.toUpperCase(otherwise.charAt(0)) + otherwise.substring(1)
        : question + " Else " + otherwise;
  }

  private static String word(Signal signal) {
    return signal.direction().name().toLowerCase(Locale.ROOT);
  }

  private static SourceLocation place(Topic topic) {
    return topic.signal().map(Signal::location).orElse(SourceLocation.NONE);
  }

  /** Checks that fields are set; an unset field is zero, empty or false in every message. */
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
        findings.checked(ContractRule.FIELD_UNSET);
        if (flow.producers(data).isEmpty()) {
          unset(topic, subscriber, data);
        }
      }
    }
  }

  private void unset(Topic topic, Endpoint subscriber, Data data) {
    Endpoint publisher = topic.publishers().get(0);
    Set<String> set = fieldsThatAreSet(topic, data.getMessageType());
    // A node as it is may know what to do without it.
    boolean asItIs = subscriber.node().getImplementation() == ComponentImplementation.NODE;
    findings.add(
        asItIs ? Severity.WARNING : Severity.ERROR,
        ContractRule.FIELD_UNSET,
        findings.at(data, Literals.DATA__FIELD_NAME),
        "%s reads the field '%s' of %s, which %s does not set."
            .formatted(subscriber.name(), data.getFieldName(), topic.name(), publisher.name()),
        set.isEmpty()
            ? "Set it, or do not read it."
            : "The fields that are set are %s: read one of them, or set this one too."
                .formatted(String.join(", ", set)),
        findings.at(publisher.first(), Literals.DATA__TOPIC_NAME));
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
