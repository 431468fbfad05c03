package dev.eventchain.agents.prompt;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal;
import dev.eventchain.project.SoftwareBase;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Message definitions in prompts, each type with its nested types. */
public final class MessageText {
  private final MessageCatalog catalog;
  private final Map<String, MessageType> types = new TreeMap<>();

  private MessageText(MessageCatalog catalog) {
    this.catalog = catalog;
  }

  /** Collects the types that existing software uses, and those that a project defines itself. */
  public static MessageText of(MessageCatalog catalog, SoftwareBase base) {
    MessageText text = new MessageText(catalog);
    Stream<String> signals = base.signals().orElse(List.of()).stream().map(Signal::messageType);
    Stream.of(signals, base.messageTypes().stream(), catalog.ownNames().stream())
        .flatMap(names -> names)
        .map(RosNames::fullMessageType)
        .distinct()
        .forEach(text::add);
    return text;
  }

  /**
   * Returns the definitions of the messages among the values of a component, after a sentence about
   * them; empty if none is a message.
   *
   * @param types the types of the values as message definitions write them
   */
  public static String ofValues(
      List<String> types, Supplier<MessageCatalog> catalog, String sentence) {
    List<String> names =
        types.stream()
            .map(MessageText::element)
            .filter(MessageText::isMessage)
            .map(RosNames::fullMessageType)
            .distinct()
            .toList();
    if (names.isEmpty()) {
      return "";
    }
    MessageText text = new MessageText(catalog.get());
    names.forEach(text::add);
    return "\n\n# Message types\n" + sentence + "\n" + text.definitions();
  }

  /** Returns whether a type, without the brackets of an array, is that of a message. */
  public static boolean isMessage(String type) {
    return type.indexOf('/') > 0;
  }

  private static String element(String type) {
    int bracket = type.indexOf('[');
    return bracket < 0 ? type : type.substring(0, bracket);
  }

  /** Skips unknown or invalid types, which the checks report. */
  private void add(String name) {
    Deque<MessageType> open = new ArrayDeque<>();
    catalog.find(name).ifPresent(open::add);
    while (!open.isEmpty()) {
      MessageType type = open.remove();
      if (types.put(type.name(), type) == null) {
        type.fields().stream()
            .map(MessageType.Field::type)
            .map(FieldType::message)
            .flatMap(Optional::stream)
            .forEach(open::add);
      }
    }
  }

  /** Returns each type with its fields, one per line, sorted by name. */
  public String definitions() {
    return types.values().stream().map(MessageText::text).collect(Collectors.joining("\n"));
  }

  private static String text(MessageType type) {
    Stream<String> constants =
        type.constants().stream()
            .map(each -> " %s %s=%s".formatted(each.type(), each.name(), each.value()));
    Stream<String> fields =
        type.fields().stream()
            .map(each -> " %s %s".formatted(within(type, each.type().toString()), each.name()));
    return Stream.of(Stream.of(type.name() + ":"), constants, fields)
        .flatMap(lines -> lines)
        .collect(Collectors.joining("\n"));
  }

  /** Returns the type of a field as definitions write it, without the package if it is the same. */
  private static String within(MessageType type, String field) {
    String own = type.name().substring(0, type.name().indexOf('/')) + "/msg/";
    return field.startsWith(own) ? field.substring(own.length()) : field.replace("/msg/", "/");
  }

  /** Returns the packages of the available types. */
  public String packages() {
    return catalog.names().stream()
        .map(name -> name.substring(0, name.indexOf('/')))
        .distinct()
        .collect(Collectors.joining(", "));
  }
}
