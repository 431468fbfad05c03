package dev.eventchain.agents;

import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.constraint.ConstraintCheck;
import dev.eventchain.agents.prompt.MetamodelText;
import dev.eventchain.agents.prompt.ModelNames;
import dev.eventchain.agents.prompt.PromptTemplate;
import dev.eventchain.agents.prompt.RuleText;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.Requirements;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;

/** Formalizes written design rules as OCL constraints (the paper's Sections IV-B and V-B). */
public final class ConstrainAgent {
  private static final PromptTemplate PROMPT = PromptTemplate.load("constrain/v1");
  private static final String ROOT = "EventChain";

  /** Features that are newer than the prompt, and are constrained by hand. */
  private static final Set<String> UNASKED =
      Set.of(
          Literals.EVENT_CHAIN__PROCESSORS.getName(),
          Literals.SOFTWARE_NODE__SYNCHRONIZED.getName(),
          Literals.SOFTWARE_NODE__TOLERANCE.getName(),
          Literals.SOFTWARE_NODE__MAPPED_TO.getName(),
          Literals.SOFTWARE_NODE__PRIORITY.getName(),
          Literals.DATA__WORST_CASE_TRANSPORT_TIME.getName(),
          Literals.DATA__COMPONENT_UNIT.getName());

  private final AgentContext context;

  /** Creates an agent for a context. */
  public ConstrainAgent(AgentContext context) {
    this.context = context;
  }

  /**
   * Formalizes design rules. Each constraint is proved to be non-trivial: a model that satisfies it
   * and one that violates it are found among the given model and its changes.
   *
   * @param metamodel the metamodel with its documentation
   * @param packages the same metamodel, loaded
   * @param rules the design rules, each to be covered by a constraint
   * @param model roots of a model of the metamodel; it stays unchanged and may violate constraints
   * @return a Complete OCL document, {@code generated.ocl}
   * @throws dev.eventchain.diagnostics.DiagnosticException FINDINGS if no answer passed its checks;
   *     and as the model throws
   */
  public AgentResult constrain(
      EPackage metamodel,
      Collection<EPackage> packages,
      Requirements rules,
      List<? extends EObject> model) {
    Map<String, String> values =
        Map.of(
            "metamodel",
                MetamodelText.of(metamodel, ROOT, feature -> !UNASKED.contains(feature.getName())),
            "event chain", ModelNames.of(model),
            "design rules", RuleText.items(rules.items()));
    List<String> ids = rules.items().stream().map(WrittenRequirement::id).toList();
    ConstraintCheck check = new ConstraintCheck(ids, packages, List.copyOf(model));
    return new RepairLoop(context, "constrain", AnswerKind.OCL)
        .run(ProjectFolder.GENERATED, PROMPT, values, Optional.empty(), check::check);
  }
}
