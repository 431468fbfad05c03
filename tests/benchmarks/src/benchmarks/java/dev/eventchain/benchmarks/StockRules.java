package dev.eventchain.benchmarks;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.ocl.OCLInput;
import org.eclipse.ocl.ParserException;
import org.eclipse.ocl.Query;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.ecore.OCL;
import org.eclipse.ocl.options.ParsingOptions;

/** Rules on stock Eclipse OCL: a query for each constraint, evaluated on each element. */
final class StockRules {

  private final Map<EClassifier, List<Query<EClassifier, EClass, EObject>>> queries =
      new HashMap<>();

  StockRules(String file) throws ParserException {
    OCL ocl = OCL.newInstance();
    var environment = ocl.getEnvironment();
    ParsingOptions.setOption(
        environment, ParsingOptions.implicitRootClass(environment), EcorePackage.Literals.EOBJECT);
    String text = "package eventchain\n" + RuleFiles.text(file) + "\nendpackage\n";
    for (Constraint constraint : ocl.parse(new OCLInput(text))) {
      if (constraint.getStereotype().equals("invariant")) {
        EClassifier context = constraint.getSpecification().getContextVariable().getType();
        queries.computeIfAbsent(context, c -> new ArrayList<>()).add(ocl.createQuery(constraint));
      }
    }
  }

  List<EObject> check(EObject root) {
    List<EObject> found = new ArrayList<>();
    check(root, found);
    for (TreeIterator<EObject> all = root.eAllContents(); all.hasNext(); ) {
      check(all.next(), found);
    }
    return found;
  }

  private void check(EObject element, List<EObject> found) {
    for (Query<EClassifier, EClass, EObject> query :
        queries.getOrDefault(element.eClass(), List.of())) {
      if (!query.check(element)) {
        found.add(element);
      }
    }
  }
}
