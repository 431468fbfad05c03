package dev.eventchain.constraints;

import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;

/** What constraints are about in a model, in the order of the model. */
final class ModelElements {

  private final Evaluation model;
  private final Map<EClassifier, List<?>> subjects = new HashMap<>();

  ModelElements(Evaluation model) {
    this.model = model;
  }

  /** What constraints of a class or a data type are about: its instances, or its values. */
  List<?> subjectsOf(EClassifier type) {
    return subjects.computeIfAbsent(type, this::find);
  }

  private List<?> find(EClassifier type) {
    return type instanceof EClass objects
        ? model.elements(objects)
        : HeldValue.of((EDataType) type, model.elements());
  }
}
