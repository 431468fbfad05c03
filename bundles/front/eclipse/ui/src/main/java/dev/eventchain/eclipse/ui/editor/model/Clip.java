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

/**
 * What was cut or copied in an editor of event chains, to be pasted in any. A component comes with
 * the data that only it uses.
 */
public final class Clip {

  private static final EventchainPackage MODEL = EventchainPackage.eINSTANCE;

  /**
   * Copies that belong to nothing.
   *
   * @param elements what was selected
   * @param data what comes with it
   * @param asOutput those of the elements that were outputs of components
   */
  private record Content(List<EObject> elements, List<EObject> data, Set<EObject> asOutput) {}

  /** All editors share it, as they share the clipboard for texts. */
  private static Content content = new Content(List.of(), List.of(), Set.of());

  private Clip() {}

  /** The data of a component that no component uses but it and others that are named. */
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

  /** Takes copies of elements. */
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

  /** Whether something can be pasted on an element of the tree. */
  public static boolean fits(Object target) {
    return !content.elements().isEmpty()
        && content.elements().stream().allMatch(element -> place(target, element) != null);
  }

  /**
   * Pastes what was taken.
   *
   * @return the new elements
   */
  public static List<EObject> paste(EditedModel model, Object target) {
    return paste(model, target, content, "paste");
  }

  /** Makes copies of elements next to them; what was taken before stays. */
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

  /** Where a copy goes to when it is pasted on an element: null for nowhere. */
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

  /** References into another chain, or to what is deleted by now, are not pasted. */
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
