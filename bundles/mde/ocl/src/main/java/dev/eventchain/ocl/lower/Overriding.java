package dev.eventchain.ocl.lower;

import dev.eventchain.ocl.parse.OclEnvironment;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypedElement;

/**
 * Dynamic dispatch of operations and properties: an object has those of its class, or of the
 * nearest superclass. Operations are the same if their names and parameter types are equal,
 * properties if their names are.
 */
final class Overriding {

  private final OclEnvironment environment;

  Overriding(OclEnvironment environment) {
    this.environment = environment;
  }

  /** Returns the members of the class itself that override a member of a superclass. */
  List<ETypedElement> in(EClass type, ETypedElement member) {
    List<ETypedElement> found = new ArrayList<>();
    for (ETypedElement each : environment.membersOf(type)) {
      if (each != member && isSame(each, member) && environment.bodyOf(each) != null) {
        found.add(each);
      }
    }
    return found;
  }

  private static boolean isSame(ETypedElement one, ETypedElement other) {
    boolean named = one.getName() != null && one.getName().equals(other.getName());
    return named
        && (one instanceof EOperation operation
            ? other instanceof EOperation another && hasSameParameters(operation, another)
            : other instanceof EStructuralFeature);
  }

  private static boolean hasSameParameters(EOperation one, EOperation other) {
    List<EParameter> parameters = one.getEParameters();
    List<EParameter> others = other.getEParameters();
    boolean same = parameters.size() == others.size();
    for (int i = 0; same && i < parameters.size(); i++) {
      same = parameters.get(i).getEType() == others.get(i).getEType();
    }
    return same;
  }
}
