package dev.eventchain.ocl;

import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.nodes.Run;
import java.util.Collection;
import org.eclipse.emf.ecore.EObject;

/** Creates {@link Evaluation}s. */
public final class Evaluations {

  private Evaluations() {}

  /**
   * Returns an evaluation on the models of some objects.
   *
   * @param objects some objects of each model; the extent of a class covers the whole resource set
   *     of each, or the tree it is in if it has no resource
   */
  public static Evaluation over(Collection<? extends EObject> objects) {
    return Run.over(objects);
  }
}
