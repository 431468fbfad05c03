package dev.eventchain.xmi;

import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.resource.Resource;

/**
 * A model that was read without a problem; every reference in it is resolved.
 *
 * @param resource holds the roots
 * @param origins where its elements, and those of the files it refers to, were written
 */
public record LoadedModel(Resource resource, Origins origins) {

  /**
   * The roots of the model, in the order of the file; none if all of them are parts of elements in
   * other files.
   */
  public List<EObject> roots() {
    return resource.getContents();
  }
}
