package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.viewers.ITreeContentProvider;

/**
 * The tree of a chain: components with the data that they read and write, then the other contents.
 * The input is an array of one chain.
 */
public final class TreeContent implements ITreeContentProvider {

  private static final EventchainPackage MODEL = EventchainPackage.eINSTANCE;

  @Override
  public Object[] getElements(Object input) {
    return (Object[]) input;
  }

  @Override
  public Object[] getChildren(Object parent) {
    return children(parent).toArray();
  }

  @Override
  public boolean hasChildren(Object element) {
    return !children(element).isEmpty();
  }

  /** Returns the children of an element. */
  public static List<Object> children(Object parent) {
    if (parent instanceof EventChain chain) {
      return ofChain(chain);
    } else if (parent instanceof Group group) {
      return new ArrayList<>(members(group));
    } else if (parent instanceof SoftwareNode node) {
      Set<Object> children = new LinkedHashSet<>(node.getInput());
      children.addAll(node.getOutput());
      children.addAll(node.eContents());
      return new ArrayList<>(children);
    }
    return parent instanceof EObject element ? new ArrayList<>(element.eContents()) : List.of();
  }

  private static List<Object> ofChain(EventChain chain) {
    List<Object> children = new ArrayList<>(chain.getSoftware());
    Stream.of(
            MODEL.getEventChain_Data(),
            MODEL.getEventChain_Requirements(),
            MODEL.getEventChain_LatencyConstraints(),
            MODEL.getEventChain_Processors(),
            MODEL.getEventChain_Measured())
        .map(feature -> new Group(chain, feature))
        .filter(group -> !members(group).isEmpty())
        .forEach(children::add);
    return children;
  }

  private static List<?> members(Group group) {
    return group.feature() == MODEL.getEventChain_Data()
        ? unused(group.chain())
        : (List<?>) group.chain().eGet(group.feature());
  }

  private static List<Data> unused(EventChain chain) {
    Set<Data> used = new LinkedHashSet<>();
    chain.getSoftware().forEach(node -> used.addAll(node.getInput()));
    chain.getSoftware().forEach(node -> used.addAll(node.getOutput()));
    return chain.getData().stream().filter(data -> !used.contains(data)).toList();
  }

  @Override
  public Object getParent(Object element) {
    return parent(element);
  }

  /**
   * Returns the parent of an element; for data, the first component that uses it. Null if there is
   * none.
   */
  static Object parent(Object element) {
    if (element instanceof Group group) {
      return group.chain();
    } else if (element instanceof Data data && data.eContainer() instanceof EventChain chain) {
      return chain.getSoftware().stream()
          .filter(node -> node.getInput().contains(data) || node.getOutput().contains(data))
          .map(Object.class::cast)
          .findFirst()
          .orElseGet(() -> new Group(chain, MODEL.getEventChain_Data()));
    } else if (element instanceof EObject object
        && object.eContainer() instanceof EventChain chain) {
      return object instanceof SoftwareNode
          ? chain
          : new Group(chain, object.eContainmentFeature());
    }
    return element instanceof EObject object ? object.eContainer() : null;
  }
}
