package dev.eventchain.agents;

import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.prompt.ModelSchema;
import dev.eventchain.agents.prompt.PromptTemplate;
import dev.eventchain.agents.prompt.RuleText;
import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.InstanceModeler;
import dev.eventchain.jsonmodels.ModelComparison;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;

/**
 * Models an event chain as a conceptual instance model (the paper's Section IV-B). The model that
 * is derived directly from the same description checks the answer, which reveals errors of the
 * language model.
 */
public final class ModelAgent {
  private static final PromptTemplate PROMPT = PromptTemplate.load("model/v1");
  private static final String FILE = "instance.json";
  private static final String EXAMPLE_NAME = "rain_wiper";
  private static final String EXAMPLE_EXISTING = "Rain_Detection (COMPONENT), Wiper_Motor (NODE)";

  private final AgentContext context;

  /**
   * An answer that passed its checks, and the model in it.
   *
   * @param model the model; its findings are errors only if they are suppressed
   */
  public record Answer(AgentResult result, Modeled<EObject> model) {}

  /** Creates an agent for a context. */
  public ModelAgent(AgentContext context) {
    this.context = context;
  }

  /**
   * Models a chain without what language models are not asked for: see {@link
   * SoftwareBase#addUnasked}.
   *
   * @param metamodel the metamodel of event chains with its documentation
   * @param chain the event-chain description
   * @param name the chain's name
   * @param requirements the functional requirements
   * @param base the existing software
   * @return a conceptual instance model, in the JSON that {@link InstanceModeler} reads, and as
   *     read by it
   * @throws dev.eventchain.diagnostics.DiagnosticException FINDINGS if no answer passed its checks;
   *     and as the model throws
   */
  public Answer model(
      EPackage metamodel,
      SourceText chain,
      String name,
      Requirements requirements,
      SoftwareBase base) {
    SourceText description = SourceText.of(chain.name(), NotAsked.without(chain));
    EventChain direct = direct(description, name, requirements, base);
    Map<String, String> values =
        Map.ofEntries(
            Map.entry("metamodel", ModelSchema.text(metamodel)),
            Map.entry("example chain name", EXAMPLE_NAME),
            Map.entry("example requirements", example("requirements.md")),
            Map.entry("example existing components", EXAMPLE_EXISTING),
            Map.entry("example event chain", example("chain.json")),
            Map.entry("example instance model", example("instance.json")),
            Map.entry("chain name", name),
            Map.entry("requirements", RuleText.items(requirements.items())),
            Map.entry("existing components", existing(base)),
            Map.entry("event chain", description.text()));
    List<Modeled<EObject>> read = new ArrayList<>();
    AgentResult result =
        new RepairLoop(context, "model", AnswerKind.JSON)
            .run(
                FILE,
                PROMPT,
                values,
                Optional.of(ModelSchema.of(direct)),
                text -> {
                  read.add(read(text));
                  return check(last(read), direct);
                });
    return new Answer(result, last(read));
  }

  /** Returns the model of a description without a language model. */
  private static EventChain direct(
      SourceText description, String name, Requirements requirements, SoftwareBase base) {
    EventChain direct =
        EventChainReader.read(description, name, requirements.items(), OptionalDouble.empty())
            .root();
    base.markExisting(direct);
    return direct;
  }

  /** Returns the model of the last answer that was read, which is the one that passed. */
  private static Modeled<EObject> last(List<Modeled<EObject>> read) {
    return read.get(read.size() - 1);
  }

  static Modeled<EObject> read(SourceText text) {
    return new InstanceModeler(List.of(EventchainPackage.eINSTANCE))
        .modelOne(text, EventchainPackage.Literals.EVENT_CHAIN);
  }

  static List<Diagnostic> check(Modeled<EObject> modeled, EventChain direct) {
    List<Diagnostic> diagnostics = new ArrayList<>(modeled.diagnostics());
    if (!Diagnostic.anyError(diagnostics)) {
      diagnostics.addAll(
          ModelComparison.compare(
              direct, modeled.root(), element -> modeled.origins().locate(element)));
    }
    return diagnostics;
  }

  private static String example(String part) {
    return PromptTemplate.resource("model/example." + part);
  }

  private static String existing(SoftwareBase base) {
    return base.components().stream()
        .map(component -> component.name() + " (" + component.implementation().getLiteral() + ")")
        .collect(Collectors.joining(", "));
  }
}
