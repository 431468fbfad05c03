package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** The clipboard of the event chain editors. A component comes with the data that only it uses. */
public final class Clip {

  private static final EventchainPackage MODEL = EventchainPackage.eINSTANCE;

  /**
   * Copies without a container.
   *
   * @param elements the selected elements
   * @param data the data that they use
   * @param asOutput those of the elements that were outputs of components
   */
  private record Content(List<EObject> elements, List<EObject> data, Set<EObject> asOutput) {}

  /** Content shared by all editors, like the clipboard for texts. */
  private static Content content = new Content(List.of(), List.of(), Set.of());

  private Clip() {}

  /** Returns the data of a component that only it and other named components use. */
  static List<Data> ownData(SoftwareNode node, Collection<? extends EObject> with) {
    Set<Data> own = new LinkedHashSet<>(node.getInput());
    own.addAll(node.getOutput());
    if (node.eContainer() instanceof EventChain chain) {
      for (SoftwareNode other : chain.getSoftware()) {
        if (other != node && !with.contains(other)) {
          own.removeAll(other.getInput());
          own.removeAll(other.getOutput());
        }
      }
    }
    return new ArrayList<>(own);
  }

  /** Copies elements. */
  public static void copy(Collection<? extends EObject> elements) {
    content = contentOf(elements);
  }

  private static Content contentOf(Collection<? extends EObject> elements) {
    Set<EObject> selected = new LinkedHashSet<>(elements);
    Set<EObject> data = new LinkedHashSet<>();
    for (EObject element : elements) {
      if (element instanceof SoftwareNode node) {
        data.addAll(ownData(node, elements));
      }
    }
    data.removeAll(selected);
    EcoreUtil.Copier copier = new EcoreUtil.Copier();
    List<EObject> copies = new ArrayList<>(copier.copyAll(selected));
    List<EObject> withThem = new ArrayList<>(copier.copyAll(data));
    copier.copyReferences();
    Set<EObject> outputs = new LinkedHashSet<>();
    for (EObject element : selected) {
      boolean isOutput =
          TreeContent.parent(element) instanceof SoftwareNode node
              && element instanceof Data
              && node.getOutput().contains(element);
      if (isOutput) {
        outputs.add(copier.get(element));
      }
    }
    return new Content(copies, withThem, outputs);
  }

  /** Returns whether the content can be pasted on an element of the tree. */
  public static boolean fits(Object target) {
    return !content.elements().isEmpty()
        && content.elements().stream().allMatch(element -> place(target, element) != null);
  }

  /**
   * Pastes the copied elements.
   *
   * @return the new elements
   */
  public static List<EObject> paste(EditedModel model, Object target) {
    return paste(model, target, content, "paste");
  }

  /** Duplicates elements next to them; the clipboard stays unchanged. */
  public static List<EObject> duplicate(EditedModel model, Object parent, List<EObject> elements) {
    return paste(model, parent, contentOf(elements), "duplicate");
  }

  private static List<EObject> paste(EditedModel model, Object target, Content from, String label) {
    List<EObject> all = new ArrayList<>(from.elements());
    all.addAll(from.data());
    EcoreUtil.Copier copier = new EcoreUtil.Copier();
    copier.copyAll(all);
    copier.copyReferences();
    Structure structure = new Structure(model);
    List<EObject> made = from.elements().stream().map(copier::get).toList();
    model.change(
        label,
        () -> {
          from.data().forEach(data -> model.chain().getData().add((Data) copier.get(data)));
          for (EObject element : from.elements()) {
            EReference place = place(target, element);
            structure.name(copier.get(element));
            put(model, target, place, copier.get(element), from.asOutput().contains(element));
          }
          all.forEach(element -> dropForeign(model, copier.get(element)));
        });
    return made;
  }

  private static void put(
      EditedModel model, Object target, EReference place, EObject copy, boolean asOutput) {
    EObject owner =
        target instanceof SoftwareNode || target instanceof Data ? (EObject) target : model.chain();
    if (owner.eClass() != place.getEContainingClass()) {
      owner = model.chain();
    }
    if (place.isMany()) {
      Structure.list(owner, place).add(copy);
    } else {
      owner.eSet(place, copy);
    }
    if (target instanceof SoftwareNode node && copy instanceof Data data) {
      (asOutput ? node.getOutput() : node.getInput()).add(data);
    }
  }

  /** Returns the reference that holds a copy pasted on an element; null if there is none. */
  private static EReference place(Object target, EObject element) {
    if (element instanceof QosProfile) {
      return target instanceof Data ? MODEL.getData_Qos() : null;
    }
    return MODEL.getEventChain().getEAllContainments().stream()
        .filter(reference -> reference != MODEL.getEventChain_Measured())
        .filter(reference -> reference.getEReferenceType() == element.eClass())
        .findFirst()
        .orElse(null);
  }

  /** Removes references to another chain or to deleted elements from a copy. */
  private static void dropForeign(EditedModel model, EObject copy) {
    List<EObject> tree = new ArrayList<>(List.of(copy));
    copy.eAllContents().forEachRemaining(tree::add);
    for (EObject element : tree) {
      for (EReference reference : element.eClass().getEAllReferences()) {
        if (reference.isContainment() || reference.isContainer() || !element.eIsSet(reference)) {
          continue;
        }
        if (reference.isMany()) {
          EList<Object> list = Structure.list(element, reference);
          list.removeIf(other -> EcoreUtil.getRootContainer((EObject) other) != model.chain());
        } else if (EcoreUtil.getRootContainer((EObject) element.eGet(reference)) != model.chain()) {
          element.eUnset(reference);
        }
      }
    }
  }
}
