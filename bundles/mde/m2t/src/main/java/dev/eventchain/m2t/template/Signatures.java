package dev.eventchain.m2t.template;

import dev.eventchain.ocl.dialect.TypeSystem;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiPredicate;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.AnyType;

/** Overload resolution of templates and queries by the types of the arguments. */
public record Signatures(TypeSystem language) {

  /**
   * Returns the callables whose parameters accept arguments of these types, most specific first.
   *
   * @param loosely true if accepting some of their values suffices
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

  /**
   * Returns whether some values of a type may be of the other type, including collections of
   * another kind.
   */
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
   * Sorts callables: each after more specific ones, and after equally specific ones with a guard;
   * otherwise the order is kept.
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
