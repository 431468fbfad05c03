package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Content proposals for the fields of a chain's elements. */
public final class Completions {

  private static final EventchainPackage MODEL = EventchainPackage.eINSTANCE;

  /** Common units of vehicle signals; the chain's own units come before them. */
  private static final List<String> UNITS =
      List.of(
          "1", "%", "m", "cm", "mm", "km", "s", "ms", "Hz", "m/s", "km/h", "m/s2", "rad", "deg",
          "rad/s", "deg/s", "N", "Nm", "Pa", "bar", "kg", "K", "degC", "V", "A", "W");

  private static final List<String> PROFILES =
      List.of("default", "sensor_data", "parameters", "services_default", "system_default");

  /** Largest depth of proposed field paths: messages contain messages. */
  private static final int DEEPEST = 6;

  private static final int MOST_PATHS = 1000;

  private final Supplier<Optional<MessageCatalog>> messages;

  /**
   * @param messages the message types of the project; empty until they are read
   */
  public Completions(Supplier<Optional<MessageCatalog>> messages) {
    this.messages = messages;
  }

  /** Returns whether there are proposals for a text feature. */
  public boolean knows(EStructuralFeature feature) {
    return feature == MODEL.getData_TopicName()
        || feature == MODEL.getData_MessageType()
        || feature == MODEL.getData_FieldName()
        || feature == MODEL.getData_Type()
        || feature == MODEL.getData_Unit()
        || feature == MODEL.getQosProfile_Name()
        || feature instanceof EReference;
  }

  /** Returns the proposals for a field that contain a text, ignoring case. */
  public List<String> proposals(EObject element, EStructuralFeature feature, String typed) {
    String wanted = typed.toLowerCase(Locale.ROOT);
    return all(element, feature).stream()
        .filter(text -> text.toLowerCase(Locale.ROOT).contains(wanted))
        .toList();
  }

  private Collection<String> all(EObject element, EStructuralFeature feature) {
    if (feature instanceof EReference reference) {
      return candidates(element, reference).stream().map(one -> Labels.of(one).name()).toList();
    } else if (feature == MODEL.getData_MessageType()) {
      return messages.get().map(catalog -> (Collection<String>) catalog.names()).orElse(List.of());
    } else if (feature == MODEL.getData_FieldName()) {
      return paths(type((Data) element));
    } else if (feature == MODEL.getData_Type()) {
      return fieldType((Data) element);
    } else if (feature == MODEL.getData_Unit()) {
      Collection<String> units = new LinkedHashSet<>(ofChain(element, feature));
      units.addAll(UNITS);
      return units;
    }
    return feature == MODEL.getQosProfile_Name() ? PROFILES : ofChain(element, feature);
  }

  /** Returns the values of the feature in other elements of the chain. */
  private static Set<String> ofChain(EObject element, EStructuralFeature feature) {
    Set<String> values = new TreeSet<>();
    EcoreUtil.getRootContainer(element)
        .eAllContents()
        .forEachRemaining(
            other -> {
              if (other != element
                  && other.eClass() == element.eClass()
                  && other.eGet(feature) instanceof String value) {
                values.add(value);
              }
            });
    return values;
  }

  /** Returns the elements that a reference may refer to, in the order of the chain. */
  public List<EObject> candidates(EObject element, EReference reference) {
    List<EObject> candidates = new ArrayList<>();
    if (EcoreUtil.getRootContainer(element) instanceof EventChain chain) {
      chain.eAllContents().forEachRemaining(candidates::add);
      candidates.removeIf(
          other -> other == element || !reference.getEReferenceType().isInstance(other));
    }
    return candidates;
  }

  private Optional<MessageType> type(Data data) {
    try {
      return data.getMessageType() == null
          ? Optional.empty()
          : messages.get().flatMap(catalog -> catalog.find(data.getMessageType()));
    } catch (DiagnosticException e) { // validation reports the errors of the definition
      return Optional.empty();
    }
  }

  private List<String> fieldType(Data data) {
    return type(data)
        .filter(type -> data.getFieldName() != null)
        .flatMap(type -> type.resolve(data.getFieldName()).type())
        .map(FieldType::toString)
        .map(List::of)
        .orElse(List.of());
  }

  private static List<String> paths(Optional<MessageType> type) {
    List<String> paths = new ArrayList<>();
    type.ifPresent(found -> addPaths(found, "", 0, paths));
    return paths;
  }

  private static void addPaths(MessageType type, String start, int depth, List<String> paths) {
    for (MessageType.Field field : type.fields()) {
      if (paths.size() >= MOST_PATHS) {
        return;
      }
      String path = start + field.name();
      paths.add(path);
      boolean single = field.type().shape() == FieldType.Shape.SINGLE;
      if (single && depth < DEEPEST && field.type().message().isPresent()) {
        addPaths(field.type().message().get(), path + ".", depth + 1, paths);
      }
    }
  }
}
