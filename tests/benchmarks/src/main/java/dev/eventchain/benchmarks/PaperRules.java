package dev.eventchain.benchmarks;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EObject;

/** The paper's two constraints in handwritten Java. */
final class PaperRules {

  private PaperRules() {}

  /** Visits every element of a model, as a validator does that knows only the root. */
  static List<Violation> check(EObject root) {
    List<Violation> found = new ArrayList<>();
    for (TreeIterator<EObject> all = root.eAllContents(); all.hasNext(); ) {
      if (all.next() instanceof SoftwareNode node) {
        check(node, found);
      }
    }
    return found;
  }

  /** Visits the list of nodes, which is the minimum. */
  static List<Violation> checkNodes(EventChain chain) {
    List<Violation> found = new ArrayList<>();
    for (SoftwareNode node : chain.getSoftware()) {
      check(node, found);
    }
    return found;
  }

  private static void check(SoftwareNode node, List<Violation> found) {
    if (node.getInput().isEmpty() || node.getOutput().isEmpty()) {
      found.add(new Violation("HasInputAndOutputData", node));
    }
    SoftwareNode next = node.getNextstep();
    if (next != null && !(next.getFrequency() >= node.getFrequency())) {
      found.add(new Violation("NextstepFrequencyEqualOrHigher", node));
    }
  }
}
