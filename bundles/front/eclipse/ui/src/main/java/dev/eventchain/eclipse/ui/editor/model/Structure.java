package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.edit.command.AbstractOverrideableCommand;

/** Creates, deletes and moves elements of the tree. Each call is one undoable step. */
public final class Structure {

  private static final EventchainPackage MODEL = EventchainPackage.eINSTANCE;

  /**
   * A kind of element that can be created below an element.
   *
   * @param name its name in the menu
   * @param feature a reference of the element: one that contains, or the inputs or outputs of a
   *     component, whose data the chain contains
   */
  public record Child(String name, EReference feature) {}

  private final EditedModel model;

  public Structure(EditedModel model) {
    this.model = model;
  }

  /**
   * Returns the kinds of elements that can be created below an element; measurements come from runs
   * only.
   */
  public static List<Child> possible(Object parent) {
    List<Child> children = new ArrayList<>();
    if (parent instanceof Group group) {
      add(children, group.feature());
    } else if (parent instanceof EventChain) {
      add(children, MODEL.getEventChain_Software());
      add(children, MODEL.getEventChain_Requirements());
      add(children, MODEL.getEventChain_LatencyConstraints());
      add(children, MODEL.getEventChain_Processors());
    } else if (parent instanceof SoftwareNode) {
      add(children, MODEL.getSoftwareNode_Input());
      add(children, MODEL.getSoftwareNode_Output());
    } else if (parent instanceof Data data && data.getQos() == null) {
      add(children, MODEL.getData_Qos());
    }
    return children;
  }

  private static void add(List<Child> children, EReference feature) {
    if (feature.getEReferenceType() == MODEL.getData() && !feature.isContainment()) {
      children.add(new Child(Words.of(feature), feature));
    } else if (feature != MODEL.getEventChain_Measured()) {
      children.add(new Child(Words.of(feature.getEReferenceType()), feature));
    }
  }

  /** Creates an element below another one, with a unique name if it has one. */
  public EObject make(Object parent, Child child) {
    EObject owner = parent instanceof Group group ? group.chain() : (EObject) parent;
    EReference feature = child.feature();
    EObject made = EcoreUtil.create(feature.getEReferenceType());
    name(made);
    model.change(
        "new " + child.name().toLowerCase(Locale.ROOT),
        () -> {
          if (!feature.isContainment()) {
            model.chain().getData().add((Data) made);
          }
          put(owner, feature, made, -1);
        });
    return made;
  }

  private static void put(EObject owner, EReference feature, EObject element, int index) {
    if (!feature.isMany()) {
      owner.eSet(feature, element);
      return;
    }
    EList<Object> list = list(owner, feature);
    list.add(index < 0 ? list.size() : index, element);
  }

  /** Gives an element a name that is unique among its kind. */
  void name(EObject element) {
    boolean isNode = element instanceof SoftwareNode;
    EStructuralFeature name = nameOf(element);
    if (name == null || element.eClass() == MODEL.getQosProfile()) {
      return;
    }
    Object had = element.eGet(name);
    String start = isNode ? "Component" : name == MODEL.getRequirement_Id() ? "REQ" : "value";
    if (element.eClass() == MODEL.getLatencyConstraint()) {
      start = "latency";
    } else if (element.eClass() == MODEL.getProcessor()) {
      start = "processor";
    }
    String base = had == null ? start : had.toString();
    String separator = name == MODEL.getRequirement_Id() ? "-" : "_";
    Set<Object> taken = new LinkedHashSet<>();
    model.chain().eAllContents().forEachRemaining(other -> addName(element, other, taken));
    String free = had == null ? base + separator + 1 : base;
    for (int i = 2; taken.contains(free); i++) {
      free = base + separator + i;
    }
    element.eSet(name, free);
  }

  private static void addName(EObject element, EObject other, Set<Object> taken) {
    if (other.eClass() == element.eClass()) {
      taken.add(other.eGet(nameOf(other)));
    }
  }

  private static EStructuralFeature nameOf(EObject element) {
    EStructuralFeature name = element.eClass().getEStructuralFeature("name");
    return name == null ? element.eClass().getEStructuralFeature("id") : name;
  }

  /**
   * Deletes elements with the references to them, the data that only a deleted component used, and
   * dependent elements, such as the measurements of a latency constraint.
   */
  public void delete(Collection<? extends EObject> elements) {
    Set<EObject> all = new LinkedHashSet<>(elements);
    all.remove(model.chain());
    for (EObject element : elements) {
      if (element instanceof SoftwareNode node) {
        all.addAll(Clip.ownData(node, elements));
      }
    }
    addDependent(all);
    if (!all.isEmpty()) {
      model.change("delete", () -> EcoreUtil.deleteAll(all, true));
    }
  }

  private void addDependent(Set<EObject> deleted) {
    Set<EObject> gone = new LinkedHashSet<>(deleted);
    deleted.forEach(element -> element.eAllContents().forEachRemaining(gone::add));
    List<EObject> dependent = new ArrayList<>();
    model
        .chain()
        .eAllContents()
        .forEachRemaining(
            element -> {
              if (!gone.contains(element) && needsOneOf(element, gone)) {
                dependent.add(element);
              }
            });
    if (!dependent.isEmpty()) {
      deleted.addAll(dependent);
      addDependent(deleted);
    }
  }

  private static boolean needsOneOf(EObject element, Set<EObject> gone) {
    return element.eClass().getEAllReferences().stream()
        .filter(reference -> reference.isRequired() && !reference.isMany())
        .anyMatch(reference -> gone.contains(element.eGet(reference)));
  }

  /**
   * Returns the list in which an element of the tree moves up or down: for data, that of the
   * component that they are shown under. Null if the element is in no list.
   *
   * @param parent its parent in the tree
   */
  private static EList<Object> listOf(Object parent, EObject element) {
    if (parent instanceof SoftwareNode node && element instanceof Data data) {
      return list(
          node,
          node.getInput().contains(data)
              ? MODEL.getSoftwareNode_Input()
              : MODEL.getSoftwareNode_Output());
    }
    EReference feature = element.eContainmentFeature();
    return feature == null || !feature.isMany() ? null : list(element.eContainer(), feature);
  }

  /** Returns whether an element can be moved by a number of places among its siblings. */
  public static boolean canMove(Object parent, EObject element, int by) {
    EList<Object> list = listOf(parent, element);
    int to = list == null ? -1 : list.indexOf(element) + by;
    return to >= 0 && to < list.size();
  }

  /** Moves an element by a number of places among its siblings. */
  public void move(Object parent, EObject element, int by) {
    EList<Object> list = listOf(parent, element);
    model.change(
        by < 0 ? "move up" : "move down", () -> list.move(list.indexOf(element) + by, element));
  }

  /**
   * Returns whether two elements are in the same list, so that one can be put next to the other.
   */
  public static boolean canMove(Object parent, EObject element, EObject neighbour) {
    EList<Object> list = listOf(parent, element);
    return list != null && list.contains(neighbour);
  }

  /**
   * Puts an element next to a neighbour.
   *
   * @param after true to put it after the neighbour, false to put it before
   */
  public void move(Object parent, EObject element, EObject neighbour, boolean after) {
    EList<Object> list = listOf(parent, element);
    int to = list.indexOf(neighbour) + (after ? 1 : 0);
    int place = list.indexOf(element) < to ? to - 1 : to;
    model.change("move", () -> list.move(place, element));
  }

  /** Returns whether data that one component reads or writes can be moved to another one. */
  public static boolean canGive(Data data, Object from, SoftwareNode to) {
    return from instanceof SoftwareNode
        && from != to
        && !to.getInput().contains(data)
        && !to.getOutput().contains(data);
  }

  /** Moves data that one component reads or writes to another one. */
  public void give(Data data, Object from, SoftwareNode to) {
    SoftwareNode former = (SoftwareNode) from;
    model.change(
        "move",
        () -> {
          if (former.getInput().remove(data)) {
            to.getInput().add(data);
          }
          if (former.getOutput().remove(data)) {
            to.getOutput().add(data);
          }
        });
  }

  /** Returns the values of a feature with several. */
  public static EList<Object> list(EObject owner, EReference feature) {
    return AbstractOverrideableCommand.getOwnerList(owner, feature);
  }
}
