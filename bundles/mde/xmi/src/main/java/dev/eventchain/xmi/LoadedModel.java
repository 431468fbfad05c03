package dev.eventchain.xmi;

import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.resource.Resource;

/**
 * A model that was read without errors; all its references are resolved.
 *
 * @param resource the resource with the roots
 * @param origins the places of its elements and of those in the files it refers to
 */
public record LoadedModel(Resource resource, Origins origins) {

  /**
   * Returns the roots of the model in the order of the file; none if all are contained in elements
   * of other files.
   */
  public List<EObject> roots() {
    return resource.getContents();
  }
}
