package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.FieldType.Kind;
import dev.eventchain.messages.FieldType.Shape;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.simulation.sensor.Listed;
import dev.eventchain.simulation.sensor.ObjectSensor.Property;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;

/** Checks the fields that are filled for each object of a list against the message type. */
final class ListedFields {

  private static final Set<Kind> NO_INTEGERS =
      EnumSet.of(Kind.BOOL, Kind.FLOAT32, Kind.FLOAT64, Kind.STRING, Kind.MESSAGE);

  private final Optional<MessageType> message;

  /** Creates a check; without a type, everything passes. */
  ListedFields(Optional<MessageType> message) {
    this.message = message;
  }

  /**
   * Returns whether a field can hold a property of each object; reports one that cannot.
   *
   * @param numbered true if kinds of objects are sent as numbers
   */
  boolean takes(ObjectReader part, String path, Property property, boolean numbered) {
    if (message.isEmpty()) {
      return true;
    }
    Optional<FieldType> type = type(part, path);
    if (type.isEmpty()) {
      return false;
    }
    boolean isWhole = property == Property.ID || (property == Property.CLASS && numbered);
    boolean isName = property == Property.CLASS && !numbered;
    Kind kind = type.get().kind();
    boolean fits =
        isWhole
            ? !NO_INTEGERS.contains(kind)
            : isName ? kind == Kind.STRING : ObjectsReader.isFloat(type.get());
    if (!fits) {
      String wanted = isWhole ? "integers" : isName ? "strings" : "float32 or float64";
      part.find(
          Diagnostic.of(
                  BenchRules.BENCH_VALUE_TYPE,
                  "'%s' is %s, but '%s' needs %s."
                      .formatted(path, type.get(), property.id(), wanted),
                  part.atKey(path))
              .withHint(hint(property, numbered)));
    }
    return fits;
  }

  private static String hint(Property property, boolean numbered) {
    if (property != Property.CLASS) {
      return "Each field of a list of objects holds a number for each of them.";
    }
    return numbered
        ? "Leave out the classes: a string gets the name of the kind."
        : "Give the numbers of the kinds: {value: class, classes: {car: 1, other: 0}}.";
  }

  /**
   * Returns whether a field can hold a value for each object; reports one that cannot.
   *
   * @param where the value is said
   */
  boolean takesValue(ObjectReader part, String path, Object value, SourceLocation where) {
    if (message.isEmpty()) {
      return true;
    }
    Listed listed = Listed.of(path);
    MessageType.Resolution list = message.get().resolve(listed.list());
    if (list.type().isEmpty()) {
      missing(part, path, list);
      return false;
    }
    Optional<MessageType> element = listed.messages(message.get());
    if (listed.ofMessages() != element.isPresent()) {
      refuseList(part, path, list.type().get());
      return false;
    }
    try {
      if (element.isPresent()) {
        MessageValue.of(element.get()).set(listed.inner(), value);
      } else {
        int size = list.type().get().shape() == Shape.ARRAY ? list.type().get().size() : 1;
        MessageValue.of(message.get()).set(path, Collections.nCopies(size, value));
      }
      return true;
    } catch (IllegalArgumentException e) {
      Diagnostic finding = Diagnostic.of(BenchRules.BENCH_VALUE_TYPE, e.getMessage(), where);
      part.find(FieldNames.hinted(finding, value, FieldNames.ofListed(message, path)));
      return false;
    }
  }

  static boolean isInteger(FieldType type) {
    return type.shape() == Shape.SINGLE && !NO_INTEGERS.contains(type.kind());
  }

  /** Returns whether a field can hold the number of objects; reports one that cannot. */
  boolean counts(ObjectReader section, String path) {
    if (message.isEmpty()) {
      return true;
    }
    MessageType.Resolution found = message.get().resolve(path);
    boolean fits = found.type().filter(ListedFields::isInteger).isPresent();
    if (!fits) {
      section.find(
          Diagnostic.of(
                  BenchRules.BENCH_VALUE_TYPE,
                  found.type().isEmpty()
                      ? found.problem()
                      : "'%s' is %s, but the number of objects needs an integer."
                          .formatted(path, found.type().get()),
                  section.at("count"))
              .withHint(found.hint()));
    }
    return fits;
  }

  /** Returns the type of a single value in a list; reports a path that leads to none. */
  private Optional<FieldType> type(ObjectReader part, String path) {
    Listed listed = Listed.of(path);
    MessageType.Resolution list = message.orElseThrow().resolve(listed.list());
    if (list.type().isEmpty()) {
      return missing(part, path, list);
    }
    boolean isList = list.type().get().shape() != Shape.SINGLE;
    boolean hasMessages = list.type().get().kind() == Kind.MESSAGE;
    if (!isList || hasMessages != listed.ofMessages()) {
      refuseList(part, path, list.type().get());
      return Optional.empty();
    }
    return listed.ofMessages() ? inner(part, path, listed) : list.type();
  }

  private static void refuseList(ObjectReader part, String path, FieldType type) {
    Listed listed = Listed.of(path);
    boolean isListOfMessages = type.shape() != Shape.SINGLE && type.kind() == Kind.MESSAGE;
    part.find(
        Diagnostic.of(
                BenchRules.BENCH_VALUE_TYPE,
                "'%s' is %s, but has to be a list of %s."
                    .formatted(listed.list(), type, listed.ofMessages() ? "messages" : "numbers"),
                part.atKey(path))
            .withHint(
                isListOfMessages
                    ? "Name a field of its messages: `%s[].NAME`.".formatted(listed.list())
                    : "Each field of a list of objects holds a value for each of them."));
  }

  /** Returns the type of a field of the messages in a list. */
  private Optional<FieldType> inner(ObjectReader part, String path, Listed listed) {
    MessageType element = listed.messages(message.orElseThrow()).orElseThrow();
    MessageType.Resolution inner = element.resolve(listed.inner());
    if (inner.type().isEmpty()) {
      return missing(part, path, inner);
    }
    FieldType type = inner.type().get();
    if (type.shape() != Shape.SINGLE) {
      part.find(
          BenchRules.BENCH_VALUE_TYPE,
          "'%s' is %s, which holds more than one value.".formatted(path, type),
          part.atKey(path));
      return Optional.empty();
    }
    return inner.type();
  }

  private static Optional<FieldType> missing(
      ObjectReader part, String path, MessageType.Resolution found) {
    part.find(
        Diagnostic.of(BenchRules.MESSAGE_FIELD_MISSING, found.problem(), part.atKey(path))
            .withHint(found.hint()));
    return Optional.empty();
  }
}
