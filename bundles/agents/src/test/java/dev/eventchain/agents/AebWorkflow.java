package dev.eventchain.agents;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.ChatModel;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import dev.eventchain.modeler.EventChainReader;
import dev.eventchain.modeler.Requirements;
import dev.eventchain.modeler.SoftwareBase;
import dev.eventchain.python.ComponentProbe;
import dev.eventchain.python.PythonEnvironment;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** The tasks of the AEB example with the inputs that the example's project gives them. */
final class AebWorkflow {
  static final Path PROJECT = Path.of("../../examples/aeb");
  static final Path RECORDINGS = PROJECT.resolve("recordings");
  static final String MODEL = "authored";

  private static final String TITLE = "Autonomous Emergency Braking";
  private static final String NAME = "aeb";
  private static final double FREQUENCY = 20.0;

  private AebWorkflow() {}

  /** Does every task and returns the results by the files they become. */
  static Map<String, AgentResult> run(ChatModel model) {
    Requirements requirements = read("requirements.md");
    Requirements rules = read("design-rules.md");
    SoftwareBase base = SoftwareBase.read(PROJECT.resolve("software-base"));
    MessageCatalog messages = MessageCatalog.of(List.of(PROJECT.resolve("software-base/msg")));
    AgentContext context = AgentContext.of(model);
    Map<String, AgentResult> results = new LinkedHashMap<>();

    AgentResult design =
        new DesignAgent(context)
            .design(TITLE, FREQUENCY, requirements, Optional.of(rules), base, messages);
    results.put("chain.json", design);
    SourceText description = SourceText.of("chain.json", design.text());
    EventChain chain =
        EventChainReader.read(description, NAME, requirements, OptionalDouble.of(FREQUENCY)).root();
    EventChainReader.markExisting(chain, base);

    ComponentProbe probe = new ComponentProbe(PythonEnvironment.ensure(message -> {}));
    ImplementAgent implement = new ImplementAgent(context, probe);
    for (SoftwareNode missing : base.missing(chain)) {
      String name = missing.getName();
      results.put(
          "components/" + name + ".py", implement.implement(description, name, requirements));
    }
    String metamodel = XmiStore.eventchainEcore();
    results.put(
        "instance.json",
        new ModelAgent(context).model(metamodel, description, NAME, requirements, base));
    results.put(
        "generated.ocl",
        new ConstrainAgent(context)
            .constrain(metamodel, List.of(EventchainPackage.eINSTANCE), rules, List.of(chain)));
    return results;
  }

  private static Requirements read(String file) {
    return Requirements.read(SourceText.read(PROJECT.resolve(file)));
  }
}
