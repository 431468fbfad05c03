package dev.eventchain.agents;

import dev.eventchain.agents.component.ComponentTester;
import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.sandbox.PythonEnvironment;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.eclipse.emf.ecore.EPackage;

/**
 * The tasks of an example with the inputs of its project.
 *
 * @param folder of the example
 * @param name in its configuration
 * @param title in its configuration
 * @param frequency in its configuration, in Hz
 */
record ExampleWorkflow(String folder, String name, String title, double frequency) {

  static final String MODEL = "authored";

  static final ExampleWorkflow AEB =
      new ExampleWorkflow("aeb", "aeb", "Autonomous Emergency Braking", 20.0);
  static final ExampleWorkflow ACC =
      new ExampleWorkflow("acc", "acc", "Adaptive Cruise Control", 50.0);
  static final ExampleWorkflow LANE_DEPARTURE =
      new ExampleWorkflow("lane-departure", "lane_departure", "Lane Departure Warning", 25.0);

  Path project() {
    return Path.of("../../examples").resolve(folder);
  }

  Path recordings() {
    return project().resolve("recordings");
  }

  /** Runs every task and returns the results by the name of their file. */
  Map<String, AgentResult> run(ChatModel model) {
    Requirements requirements = read("requirements.md");
    Requirements rules = read("design-rules.md");
    SoftwareBase base = SoftwareBase.read(project().resolve("software-base"));
    MessageCatalog messages = MessageCatalog.of(List.of(project().resolve("software-base/msg")));
    AgentContext context = AgentContext.of(model);
    Map<String, AgentResult> results = new LinkedHashMap<>();

    AgentResult design =
        new DesignAgent(context)
            .design(
                new DesignAgent.Asked(
                    title, frequency, requirements, Optional.of(rules), base, messages));
    results.put("chain.json", design);
    SourceText description = SourceText.of("chain.json", design.text());
    EventChain chain =
        EventChainReader.read(description, name, requirements.items(), OptionalDouble.of(frequency))
            .root();
    base.markExisting(chain);

    ComponentProbe probe = new ComponentProbe(PythonEnvironment.ensure(message -> {}));
    ImplementAgent implement = new ImplementAgent(context, probe, List.of());
    for (SoftwareNode missing : base.missing(chain)) {
      String component = missing.getName();
      AgentResult proposed = new TestAgent(context).propose(description, component, requirements);
      results.put("tests/" + component + ".json", proposed);
      SourceText tests = SourceText.of("tests/" + component + ".yaml", proposed.text());
      results.put(
          "components/" + component + ".py",
          implement.implement(
              description,
              component,
              requirements,
              Optional.of(ComponentTester.read(tests, description, component, requirements))));
    }
    EPackage metamodel = EventChainMetamodel.documented();
    results.put(
        "instance.json",
        new ModelAgent(context).model(metamodel, description, name, requirements, base).result());
    results.put(
        "generated.ocl",
        new ConstrainAgent(context)
            .constrain(metamodel, List.of(EventchainPackage.eINSTANCE), rules, List.of(chain)));
    return results;
  }

  private Requirements read(String file) {
    return Requirements.read(SourceText.read(project().resolve(file)));
  }
}
