package dev.eventchain.pipeline.generate;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** The message types of a chain as a model of {@code metamodel/messages.ecore}, for templates. */
public final class MessageModel {

  private final MessageCatalog catalog;
  private final EObject root = create("MessageCatalog");
  private final Map<String, EObject> types = new LinkedHashMap<>();

  private MessageModel(MessageCatalog catalog) {
    this.catalog = catalog;
  }

  /** Returns the metamodel. */
  public static EPackage metamodel() {
    return EventChainMetamodel.messages();
  }

  /**
   * Returns the types of a chain's data, and those that they contain. Omits undefined types, which
   * the contracts on messages report.
   *
   * @return the one root of the model; a type comes after all that it contains; otherwise, types
   *     are sorted by name
   */
  static EObject of(EventChain chain, MessageCatalog catalog) {
    MessageModel model = new MessageModel(catalog);
    SortedSet<String> names = new TreeSet<>();
    for (Data data : chain.getData()) {
      if (data.getMessageType() != null) {
        names.add(RosNames.fullMessageType(data.getMessageType()));
      }
    }
    names.forEach(name -> model.catalog.find(name).ifPresent(model::add));
    values(model.root, "types").addAll(model.types.values());
    return model.root;
  }

  private EObject add(MessageType type) {
    EObject known = types.get(type.name());
    if (known != null) {
      return known;
    }
    EObject added = create("MessageType");
    String[] parts = type.name().split("/", -1);
    set(added, "name", type.name());
    set(added, "packageName", parts[0]);
    set(added, "shortName", parts[parts.length - 1]);
    type.fields().forEach(field -> values(added, "fields").add(add(field)));
    types.put(type.name(), added);
    return added;
  }

  private EObject add(MessageType.Field field) {
    FieldType type = field.type();
    EObject added = create("MessageField");
    set(added, "name", field.name());
    type.message()
        .ifPresentOrElse(
            message -> set(added, "message", add(message)),
            () -> set(added, "primitive", type.kind().name().toLowerCase(Locale.ROOT)));
    EEnum shapes = (EEnum) EventChainMetamodel.messages().getEClassifier("FieldShape");
    set(added, "shape", shapes.getEEnumLiteral(type.shape().name()).getInstance());
    set(added, "size", type.size());
    set(added, "stringBound", type.stringBound());
    field.defaultValue().ifPresent(value -> addAll(added, texts(type.kind(), value)));
    return added;
  }

  private static void addAll(EObject field, List<String> defaults) {
    field.eSet(field.eClass().getEStructuralFeature("defaultValue"), defaults);
  }

  /** Returns the values of a default, in the notation of definitions. */
  private static List<String> texts(FieldType.Kind kind, Object value) {
    List<String> texts = new ArrayList<>();
    if (value instanceof List<?> list) {
      list.forEach(item -> texts.add(text(kind, item)));
    } else if (value.getClass().isArray()) {
      for (int i = 0; i < Array.getLength(value); i++) {
        texts.add(text(kind, Array.get(value, i)));
      }
    } else {
      texts.add(text(kind, value));
    }
    return texts;
  }

  /**
   * Returns a value as text. Unsigned values arrive as signed ones of the same width, since Java
   * has no unsigned types.
   */
  private static String text(FieldType.Kind kind, Object value) {
    if (!(value instanceof Number number)) {
      return value.toString();
    }
    return switch (kind) {
      case BYTE, CHAR, UINT8 -> Integer.toString(number.intValue() & 0xff);
      case UINT16 -> Integer.toString(number.intValue() & 0xffff);
      case UINT32 -> Long.toString(number.longValue() & 0xffff_ffffL);
      case UINT64 -> Long.toUnsignedString(number.longValue());
      default -> number.toString();
    };
  }

  private static EObject create(String name) {
    return EcoreUtil.create((EClass) EventChainMetamodel.messages().getEClassifier(name));
  }

  private static void set(EObject object, String feature, Object value) {
    object.eSet(object.eClass().getEStructuralFeature(feature), value);
  }

  @SuppressWarnings("unchecked") // the metamodel defines the types of the features
  private static List<EObject> values(EObject object, String feature) {
    return (List<EObject>) object.eGet(object.eClass().getEStructuralFeature(feature));
  }
}
