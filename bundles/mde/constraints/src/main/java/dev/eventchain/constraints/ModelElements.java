package dev.eventchain.constraints;

import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;

/** The subjects of constraints in a model, in model order. */
final class ModelElements {

  private final Evaluation model;
  private final Map<EClassifier, List<?>> subjects = new HashMap<>();

  ModelElements(Evaluation model) {
    this.model = model;
  }

  /** Returns the instances of a class or the values of a data type. */
  List<?> subjectsOf(EClassifier type) {
    return subjects.computeIfAbsent(type, this::find);
  }

  private List<?> find(EClassifier type) {
    return type instanceof EClass objects
        ? model.elements(objects)
        : HeldValue.of((EDataType) type, model.elements());
  }
}
