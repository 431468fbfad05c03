package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.chain.ChainView;
import dev.eventchain.agents.component.ImplementationCheck;
import dev.eventchain.agents.constraint.ConstraintCheck;
import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.InstanceModeler;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.jsonmodels.ModelComparison;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.ComponentProbe;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;

/** The recorded answers of an example, each with the checks of its task. */
final class GoodAnswers {
  private static final JsonMapper MAPPER = new JsonMapper();

  private final ExampleWorkflow example;
  private final Requirements requirements;
  private final Requirements rules;
  private final SoftwareBase base;
  private final MessageCatalog messages;
  private final Set<String> existing;
  private final SourceText description;
  private final EventChain chain;

  GoodAnswers(ExampleWorkflow example) throws IOException {
    this.example = example;
    requirements = read("requirements.md");
    rules = read("design-rules.md");
    base = SoftwareBase.read(example.project().resolve("software-base"));
    messages = MessageCatalog.of(List.of(example.project().resolve("software-base/msg")));
    existing =
        base.components().stream().map(SoftwareBase.Component::name).collect(Collectors.toSet());
    GoodAnswer design = design().get(0);
    description = SourceText.of("chain.json", design.block());
    chain = chain(SourceText.of("chain.json", NotAsked.without(description)));
    base.markExisting(chain);
  }

  List<GoodAnswer> design() throws IOException {
    return recorded(
        "design",
        AnswerKind.JSON,
        text -> DesignAgent.check(text, requirements, base, messages),
        (one, other) -> compare(chain(one), chain(other)));
  }

  List<GoodAnswer> model() throws IOException {
    return recorded(
        "model",
        AnswerKind.JSON,
        text -> ModelAgent.check(ModelAgent.read(text), chain),
        (one, other) -> compare(instance(one), instance(other)));
  }

  List<GoodAnswer> constrain() throws IOException {
    List<String> ids = rules.items().stream().map(WrittenRequirement::id).toList();
    ConstraintCheck check =
        new ConstraintCheck(ids, List.of(EventchainPackage.eINSTANCE), List.of(chain));
    return recorded("constrain", AnswerKind.OCL, check::check, GoodAnswers::changedLines);
  }

  List<GoodAnswer> implement(ComponentProbe probe) throws IOException {
    List<ChainView.Component> components =
        ChainView.of(JsonDocument.parse(description).root()).components();
    List<GoodAnswer> answers = new ArrayList<>();
    for (String text : texts("implement")) {
      ChainView.Component component =
          components.stream()
              .filter(each -> text.contains("\nclass " + each.name() + ":"))
              .findFirst()
              .orElseThrow();
      answers.add(
          new GoodAnswer(
              example.folder() + ", " + component.name(),
              AnswerKind.PYTHON,
              text,
              existing,
              new ImplementationCheck(
                      probe,
                      component,
                      Optional.empty(),
                      List.of(),
                      () -> MessageCatalog.of(List.of()))
                  ::check,
              GoodAnswers::changedLines));
    }
    return answers;
  }

  private List<GoodAnswer> recorded(
      String task,
      AnswerKind kind,
      Function<SourceText, List<Diagnostic>> check,
      BiFunction<SourceText, SourceText, List<String>> differences)
      throws IOException {
    String name = example.folder() + ", " + task;
    return texts(task).stream()
        .map(text -> new GoodAnswer(name, kind, text, existing, check, differences))
        .toList();
  }

  private List<String> texts(String task) throws IOException {
    List<String> texts = new ArrayList<>();
    try (Stream<Path> files = Files.list(example.recordings().resolve(task))) {
      for (Path file : files.sorted().toList()) {
        List<String> lines = new ArrayList<>();
        JsonNode sample = MAPPER.readTree(file.toFile()).at("/samples/0/text");
        sample.forEach(line -> lines.add(line.asText()));
        texts.add(String.join("\n", lines));
      }
    }
    return texts;
  }

  private EventChain chain(SourceText text) {
    return EventChainReader.read(text, example.name(), requirements.items(), OptionalDouble.empty())
        .root();
  }

  private static EObject instance(SourceText text) {
    return new InstanceModeler(List.of(EventchainPackage.eINSTANCE))
        .modelOne(text, EventchainPackage.Literals.EVENT_CHAIN)
        .root();
  }

  private static List<String> compare(EObject one, EObject other) {
    return ModelComparison.compare(one, other, element -> SourceLocation.NONE).stream()
        .map(Diagnostic::message)
        .toList();
  }

  /** Returns the lines between the common beginning and the common end of two texts. */
  static List<String> changedLines(SourceText one, SourceText other) {
    List<String> before = new ArrayList<>(one.text().lines().toList());
    List<String> after = new ArrayList<>(other.text().lines().toList());
    while (!before.isEmpty() && !after.isEmpty() && before.get(0).equals(after.get(0))) {
      before.remove(0);
      after.remove(0);
    }
    while (!before.isEmpty() && !after.isEmpty() && last(before).equals(last(after))) {
      before.remove(before.size() - 1);
      after.remove(after.size() - 1);
    }
    return Stream.concat(
            before.stream().map(line -> "- " + line), after.stream().map(line -> "+ " + line))
        .toList();
  }

  private static String last(List<String> lines) {
    return lines.get(lines.size() - 1);
  }

  private Requirements read(String file) {
    return Requirements.read(SourceText.read(example.project().resolve(file)));
  }
}
