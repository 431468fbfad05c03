package dev.eventchain.contracts;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EAttribute;

/** Checks that message types and fields exist and match their use in the chain and the signals. */
final class TypeContracts {

  private final MessageCatalog catalog;
  private final Findings findings;
  private final Map<String, Optional<MessageType>> types = new HashMap<>();
  private final Set<String> broken = new HashSet<>();

  TypeContracts(MessageCatalog catalog, Findings findings) {
    this.catalog = catalog;
    this.findings = findings;
  }

  void check(Topic topic) {
    for (Endpoint endpoint : topic.endpoints()) {
      Set<String> seen = new HashSet<>();
      for (Data data : endpoint.data()) {
        String type = data.getMessageType();
        if (isQualified(type)) {
          if (seen.add(type)) {
            known(type, topic.name(), () -> findings.at(data, Literals.DATA__MESSAGE_TYPE));
          }
          typeOf(type).ifPresent(found -> field(found, data));
        }
      }
    }
    topic.signal().ifPresent(this::signal);
  }

  private void signal(Signal signal) {
    if (isQualified(signal.messageType())) {
      known(signal.messageType(), signal.topic(), signal::location);
      typeOf(signal.messageType())
          .ifPresent(type -> signal.fields().forEach(field -> field(type, field)));
    }
  }

  /** Returns whether a type satisfies {@code MessageTypeIsQualified}, which reports other names. */
  static boolean isQualified(String type) {
    return type != null && RosNames.isMessageType(type);
  }

  /** Returns the type of an existing field; empty if the field is illegal or its type unknown. */
  Optional<FieldType> fieldType(Data data) {
    return data.getFieldName() == null || !isQualified(data.getMessageType())
        ? Optional.empty()
        : typeOf(data.getMessageType()).flatMap(type -> type.resolve(data.getFieldName()).type());
  }

  /** Returns whether the type of the messages with some data is known. */
  boolean isKnown(Data data) {
    return isQualified(data.getMessageType()) && typeOf(data.getMessageType()).isPresent();
  }

  /** Returns whether the messages with some data have a header with a stamp. */
  boolean isStamped(Data data) {
    return typeOf(data.getMessageType())
        .flatMap(type -> type.resolve("header").type())
        .filter(field -> field.shape() == FieldType.Shape.SINGLE)
        .flatMap(FieldType::message)
        .filter(type -> type.name().equals("std_msgs/msg/Header"))
        .isPresent();
  }

  private Optional<MessageType> typeOf(String name) {
    return types.computeIfAbsent(name, this::find);
  }

  private Optional<MessageType> find(String name) {
    try {
      return catalog.find(name);
    } catch (DiagnosticException e) {
      // The catalog reports an invalid definition once, at its location.
      broken.add(name);
      return Optional.empty();
    }
  }

  private void known(String type, String topic, Supplier<SourceLocation> place) {
    findings.checked(ContractRule.MESSAGE_UNKNOWN);
    if (typeOf(type).isEmpty() && !broken.contains(type)) {
      findings.error(
          ContractRule.MESSAGE_UNKNOWN,
          place.get(),
          "There is no message type '%s', which %s is said to carry.".formatted(type, topic),
          nearest(type));
    }
  }

  /**
   * Returns a hint: the same name in another package, otherwise the nearest name, and the searched
   * folders.
   */
  private String nearest(String type) {
    String simpleName = type.substring(type.lastIndexOf('/'));
    List<String> elsewhere =
        catalog.names().stream().filter(name -> name.endsWith(simpleName)).toList();
    Optional<String> meant =
        elsewhere.isEmpty()
            ? NearestName.of(RosNames.fullMessageType(type), catalog.names())
            : Optional.of(String.join("` or `", elsewhere));
    String searched =
        catalog.folders().isEmpty()
            ? "the standard types of ROS 2"
            : catalog.folders().stream()
                .map(folder -> folder.toString().replace('\\', '/'))
                .collect(Collectors.joining(" and ", "the standard types of ROS 2 and in ", ""));
    String wanted = RosNames.fullMessageType(type) + ".msg";
    return catalog.hintOfDistribution(type, "")
        + meant.map(name -> "Did you mean `" + name + "`? ").orElse("")
        + "Looked for among %s; a definition of your own is PACKAGE/msg/NAME.msg there: %s."
            .formatted(searched, wanted);
  }

  private void field(MessageType type, Data data) {
    if (data.getFieldName() != null && !data.getFieldName().isEmpty()) {
      String user = "the data '" + data.getName() + "'";
      Function<EAttribute, SourceLocation> place = feature -> findings.at(data, feature);
      field(type, data.getFieldName(), data.getType(), user, place);
    }
  }

  private void field(MessageType type, Signal.Field field) {
    String user = "the signal's description";
    field(type, field.path(), field.type(), user, feature -> field.location());
  }

  private void field(
      MessageType type,
      String path,
      String declared,
      String user,
      Function<EAttribute, SourceLocation> place) {
    findings.checked(ContractRule.FIELD_UNKNOWN);
    MessageType.Resolution resolution = type.resolve(path);
    if (resolution.type().isEmpty()) {
      findings.error(
          ContractRule.FIELD_UNKNOWN,
          place.apply(Literals.DATA__FIELD_NAME),
          "%s names the field '%s' of %s, but %s"
              .formatted(capitalized(user), path, type, resolution.problem()),
          (catalog.hintOfDistribution(type.name(), path) + resolution.hint()).strip());
    } else if (declared != null && !declared.isBlank()) {
      findings.checked(ContractRule.TYPE_MISMATCH);
      if (!DeclaredType.fits(declared, resolution.type().get())) {
        findings.error(
            ContractRule.TYPE_MISMATCH,
            place.apply(Literals.DATA__TYPE),
            "%s gives the type of '%s' as '%s', but %s has '%s' there."
                .formatted(capitalized(user), path, declared, type, resolution.type().get()),
            "Write '%s', and convert inside the component.".formatted(resolution.type().get()));
      }
    }
  }

  private static String capitalized(String text) {
    return Character.toUpperCase(text.charAt(0)) + text.substring(1);
  }
}
