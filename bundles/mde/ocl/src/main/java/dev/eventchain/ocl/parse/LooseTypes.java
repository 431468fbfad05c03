package dev.eventchain.ocl.parse;

import dev.eventchain.ocl.dialect.Dialect;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.util.TypeUtil;
import org.eclipse.ocl.utilities.TypedElement;

/** Resolves calls that a dialect allows although standard OCL refuses their types. */
final class LooseTypes {

  /** Comparisons take any types: a collection is just not equal to a single value. */
  private static final Set<String> COMPARISONS = Set.of("=", "<>");

  private LooseTypes() {}

  /** Returns the operation of a call in a dialect; {@code null} if there is none. */
  static EOperation operation(
      OclEnvironment environment,
      EClassifier owner,
      String name,
      List<? extends TypedElement<EClassifier>> arguments) {
    Dialect dialect = environment.dialect();
    boolean loose = owner instanceof CollectionType<?, ?> || COMPARISONS.contains(name);
    EOperation found =
        loose && dialect.takesAnyElement() ? named(environment, owner, name, arguments) : null;
    if (found == null) {
      found = environment.libraries().lookup(owner, name, arguments, true);
    }
    Optional<EClassifier> assumed = dialect.assumed(owner);
    return found == null && assumed.isPresent()
        ? environment.lookupOperation(assumed.get(), name, arguments)
        : found;
  }

  /** Returns the operation of a name whose parameters are collections where the arguments are. */
  private static EOperation named(
      OclEnvironment environment,
      EClassifier owner,
      String name,
      List<? extends TypedElement<EClassifier>> arguments) {
    for (EOperation each : TypeUtil.getOperations(environment, owner)) {
      if (each.getName().equals(name)
          && (COMPARISONS.contains(name) || suits(each.getEParameters(), arguments))) {
        return each;
      }
    }
    return null;
  }

  private static boolean suits(
      List<EParameter> parameters, List<? extends TypedElement<EClassifier>> arguments) {
    if (parameters.size() != arguments.size()) {
      return false;
    }
    for (int i = 0; i < parameters.size(); i++) {
      EClassifier argument = arguments.get(i).getType();
      if (parameters.get(i).getEType() instanceof CollectionType<?, ?>
          && !(argument instanceof CollectionType<?, ?>)) {
        return false;
      }
    }
    return true;
  }
}
