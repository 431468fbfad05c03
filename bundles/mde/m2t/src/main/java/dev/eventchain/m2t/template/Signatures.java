package dev.eventchain.m2t.template;

import dev.eventchain.ocl.dialect.TypeSystem;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiPredicate;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.AnyType;

/** Which templates and queries a call may mean, by the types of its arguments. */
public record Signatures(TypeSystem language) {

  /**
   * Those whose parameters take arguments of these types, the most special first.
   *
   * @param loosely whether to take some of their values is enough
   */
  List<Callable> suiting(List<EClassifier> types, List<Callable> candidates, boolean loosely) {
    return bySpeciality(
        candidates.stream()
            .filter(
                callable -> loosely ? all(types, callable, this::mayFit) : conform(types, callable))
            .toList());
  }

  private boolean conform(List<EClassifier> types, Callable callable) {
    return all(types, callable, language::conforms);
  }

  private static boolean all(
      List<EClassifier> types, Callable callable, BiPredicate<EClassifier, EClassifier> test) {
    for (int i = 0; i < types.size(); i++) {
      if (!test.test(types.get(i), callable.parameters().get(i).type())) {
        return false;
      }
    }
    return true;
  }

  /** Whether some values of a type are of the other type, collections of another kind included. */
  public boolean mayFit(EClassifier type, EClassifier required) {
    if (type instanceof AnyType<?> || required instanceof AnyType<?>) {
      return true;
    }
    Optional<EClassifier> elements = language.elementType(type);
    Optional<EClassifier> requiredElements = language.elementType(required);
    if (elements.isPresent() && requiredElements.isPresent()) {
      return mayFit(elements.get(), requiredElements.get());
    }
    return language.conforms(type, required) || language.conforms(required, type);
  }

  /**
   * Each callable comes after those that are more special, and after its likes that have a guard;
   * otherwise the order stays.
   */
  List<Callable> bySpeciality(List<Callable> candidates) {
    List<Callable> rest = new ArrayList<>(candidates);
    rest.sort(Comparator.comparing(callable -> !callable.hasGuard()));
    List<Callable> sorted = new ArrayList<>();
    while (!rest.isEmpty()) {
      Callable next =
          rest.stream()
              .filter(each -> rest.stream().noneMatch(other -> isMoreSpecial(other, each)))
              .findFirst()
              .orElse(rest.get(0));
      sorted.add(next);
      rest.remove(next);
    }
    return List.copyOf(sorted);
  }

  private boolean isMoreSpecial(Callable one, Callable other) {
    return one != other && conform(types(one), other) && !conform(types(other), one);
  }

  private static List<EClassifier> types(Callable callable) {
    return callable.parameters().stream().map(Callable.Parameter::type).toList();
  }
}
