package dev.eventchain.jsonmodels;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/** The classes of some metamodels by their names. */
final class ClassIndex {

  private final Map<String, List<EClass>> classes = new TreeMap<>();

  ClassIndex(Collection<? extends EPackage> metamodels) {
    metamodels.forEach(this::add);
  }

  private void add(EPackage ePackage) {
    for (EClassifier classifier : ePackage.getEClassifiers()) {
      if (classifier instanceof EClass eClass) {
        classes.computeIfAbsent(eClass.getName(), name -> new ArrayList<>()).add(eClass);
      }
    }
    ePackage.getESubpackages().forEach(this::add);
  }

  /** Returns the sorted names of the classes that can be instantiated. */
  List<String> concreteNames() {
    return classes.entrySet().stream()
        .filter(entry -> entry.getValue().stream().anyMatch(c -> !c.isAbstract()))
        .map(Map.Entry::getKey)
        .toList();
  }

  /**
   * Returns the classes that a name can mean: {@code Book}, {@code library.Book}, {@code
   * library::Book}, {@code library:Book}, or a URI that ends with {@code #//Book}.
   */
  List<EClass> find(String name) {
    int fragment = name.indexOf("#//");
    String qualifier = "";
    String simple = name;
    if (fragment >= 0) {
      qualifier = name.substring(0, fragment);
      simple = name.substring(fragment + 3);
    } else {
      int end = Math.max(name.lastIndexOf('.'), name.lastIndexOf(':'));
      if (end > 0) {
        simple = name.substring(end + 1);
        qualifier = name.substring(0, end).replace("::", ".").replace(":", "");
        qualifier = qualifier.substring(qualifier.lastIndexOf('.') + 1);
      }
    }
    String wanted = qualifier;
    return classes.getOrDefault(simple, List.of()).stream()
        .filter(eClass -> isIn(eClass, wanted))
        .toList();
  }

  private static boolean isIn(EClass eClass, String qualifier) {
    EPackage ePackage = eClass.getEPackage();
    return qualifier.isEmpty()
        || qualifier.equals(ePackage.getName())
        || qualifier.equals(ePackage.getNsPrefix())
        || qualifier.equals(ePackage.getNsURI());
  }
}
