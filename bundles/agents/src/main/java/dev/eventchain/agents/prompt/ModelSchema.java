package dev.eventchain.agents.prompt;

import dev.eventchain.jsonmodels.MetamodelSchema;
import dev.eventchain.llm.chat.AnswerSchema;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * The schema of an instance model of an event chain. It is narrower than the metamodel: it excludes
 * values that are measured, derived or added later, and constants. The ids of requirements and of
 * components are the existing ones; the ids of data are free, since identifying the data is the
 * task.
 */
public final class ModelSchema {

  private static final List<EStructuralFeature> NOT_ASKED =
      List.of(
          Literals.EVENT_CHAIN__DESCRIPTION,
          Literals.EVENT_CHAIN__LATENCY_CONSTRAINTS,
          Literals.EVENT_CHAIN__PROCESSORS,
          Literals.EVENT_CHAIN__MEASURED,
          Literals.SOFTWARE_NODE__BEST_CASE_EXECUTION_TIME,
          Literals.SOFTWARE_NODE__WORST_CASE_EXECUTION_TIME,
          Literals.SOFTWARE_NODE__MEMORY,
          Literals.SOFTWARE_NODE__SYNCHRONIZED,
          Literals.SOFTWARE_NODE__TOLERANCE,
          Literals.SOFTWARE_NODE__MAPPED_TO,
          Literals.SOFTWARE_NODE__PRIORITY,
          Literals.SOFTWARE_NODE__MEASURED,
          Literals.DATA__WORST_CASE_TRANSPORT_TIME,
          Literals.DATA__COMPONENT_UNIT);

  private static final List<EStructuralFeature> ALWAYS =
      List.of(
          Literals.EVENT_CHAIN__NAME,
          Literals.SOFTWARE_NODE__NAME,
          Literals.SOFTWARE_NODE__ORIGIN,
          Literals.SOFTWARE_NODE__IMPLEMENTATION,
          Literals.DATA__NAME,
          Literals.DATA__TOPIC_NAME,
          Literals.DATA__MESSAGE_TYPE,
          Literals.DATA__FIELD_NAME,
          Literals.QOS_PROFILE__NAME,
          Literals.REQUIREMENT__TEXT);

  private ModelSchema() {}

  /**
   * Returns the text of what an answer may contain.
   *
   * @param metamodel the metamodel of event chains with its documentation
   */
  public static String text(EPackage metamodel) {
    Set<String> left =
        NOT_ASKED.stream().map(ModelSchema::name).collect(Collectors.toUnmodifiableSet());
    return MetamodelText.of(
        metamodel, Literals.EVENT_CHAIN.getName(), feature -> !left.contains(name(feature)));
  }

  private static String name(EStructuralFeature feature) {
    return feature.getEContainingClass().getName() + "." + feature.getName();
  }

  /**
   * Returns the schema.
   *
   * @param direct the chain derived directly from its description
   */
  public static AnswerSchema of(EventChain direct) {
    MetamodelSchema schema =
        MetamodelSchema.of(List.of(EventchainPackage.eINSTANCE), Literals.EVENT_CHAIN)
            .without(NOT_ASKED)
            .demanding(ALWAYS)
            .knowing(
                Literals.REQUIREMENT,
                direct.getRequirements().stream().map(Requirement::getId).toList())
            .knowing(
                Literals.SOFTWARE_NODE,
                direct.getSoftware().stream().map(SoftwareNode::getName).toList());
    return new AnswerSchema(schema.nested(), schema.flat());
  }
}
