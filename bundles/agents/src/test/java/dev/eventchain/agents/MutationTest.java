package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.agents.GoodAnswer.Result;
import dev.eventchain.agents.Mutation.Outcome;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.sandbox.PythonEnvironment;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Mutants of answers, 500 by default and 20,000 in the profile {@code thorough}: each mutation has
 * its declared outcome, and none crashes. The mutants are the same each time.
 */
class MutationTest {
  private static final int MUTANTS = Integer.getInteger("mutants", 250);

  /**
   * Shares of all mutants: components are called in processes, and constraints proved on many
   * models.
   */
  private static final int DESIGNS = 480;

  private static final int MODELS = 400;
  private static final int CONSTRAINTS = 87;
  private static final int VACUOUS = 3;
  private static final int COMPONENTS = 30;
  private static final int SHARES = DESIGNS + MODELS + CONSTRAINTS + VACUOUS + COMPONENTS;

  private static List<GoodAnswers> examples;

  @BeforeAll
  static void examples() throws IOException {
    examples = new ArrayList<>();
    for (ExampleWorkflow example : ExampleRecordingsTest.examples()) {
      examples.add(new GoodAnswers(example));
    }
  }

  @Test
  void designs() throws IOException {
    List<GoodAnswer> answers = new ArrayList<>();
    for (GoodAnswers example : examples) {
      answers.addAll(example.design());
    }
    run(answers, withJson(DesignMutations.all()), DESIGNS);
  }

  @Test
  void models() throws IOException {
    List<GoodAnswer> answers = new ArrayList<>();
    for (GoodAnswers example : examples) {
      answers.addAll(example.model());
    }
    run(answers, withJson(ModelMutations.all()), MODELS);
  }

  @Test
  void constraints() throws IOException {
    List<GoodAnswer> answers = new ArrayList<>();
    for (GoodAnswers example : examples) {
      answers.addAll(example.constrain());
    }
    run(answers, with(OclMutations.all()), CONSTRAINTS);
    run(answers, OclMutations.slow(), VACUOUS);
  }

  @Test
  void components() throws IOException {
    ComponentProbe probe = new ComponentProbe(PythonEnvironment.ensure(message -> {}));
    List<GoodAnswer> answers = new ArrayList<>();
    for (GoodAnswers example : examples) {
      answers.addAll(example.implement(probe));
    }
    run(answers, with(PythonMutations.all()), COMPONENTS);
  }

  @Test
  void aDifferenceIsListedByLine() {
    assertEquals(
        List.of("- b", "+ c", "+ d"),
        GoodAnswers.changedLines(
            SourceText.of("x", "a\nb\ne\n"), SourceText.of("y", "a\nc\nd\ne\n")));
  }

  private static List<Mutation> with(List<Mutation> more) {
    List<Mutation> all = new ArrayList<>(TextMutations.around());
    all.addAll(TextMutations.broken());
    all.addAll(more);
    return all;
  }

  private static List<Mutation> withJson(List<Mutation> more) {
    List<Mutation> all = with(JsonMutations.all());
    all.addAll(more);
    return all;
  }

  /** Runs the mutations in turn, each on the answers in turn. */
  private static void run(List<GoodAnswer> answers, List<Mutation> mutations, int share) {
    for (GoodAnswer answer : answers) {
      Result itself = answer.judge(answer.text());
      assertEquals(new Result(Outcome.EQUAL, List.of()), itself, answer.name());
    }
    int wanted = Math.max(mutations.size(), (int) ((long) MUTANTS * share / SHARES));
    List<String> wrong = new ArrayList<>();
    TreeMap<String, Integer> made = new TreeMap<>();
    mutations.forEach(mutation -> made.put(mutation.name(), 0));
    int count = 0;
    for (int i = 0; count < wanted; i++) {
      Mutation mutation = mutations.get(i % mutations.size());
      GoodAnswer answer = answers.get(i / mutations.size() % answers.size());
      Optional<String> changed = mutation.change().of(answer, new Random(i));
      if (changed.isPresent() && !changed.get().equals(answer.text())) {
        count++;
        made.merge(mutation.name(), 1, Integer::sum);
        problem(answer, mutation, changed.get(), i).ifPresent(wrong::add);
      }
      assertTrue(i < 100 * wanted, "mutations that change nothing: " + made);
    }
    assertEquals("", String.join("\n\n", wrong), wrong.size() + " of " + count);
    assertEquals(List.of(), made.keySet().stream().filter(name -> made.get(name) == 0).toList());
  }

  private static Optional<String> problem(
      GoodAnswer answer, Mutation mutation, String changed, int seed) {
    Result result;
    try {
      result = answer.judge(changed);
    } catch (RuntimeException e) {
      result = new Result(null, List.of("it crashed: " + e));
    }
    if (result.outcome() == mutation.outcome()) {
      return Optional.empty();
    }
    List<String> change =
        GoodAnswers.changedLines(
            SourceText.of("before", answer.text()), SourceText.of("after", changed));
    return Optional.of(
        String.format(
            Locale.ROOT,
            "%s: '%s' (seed %d) is %s, not %s: %s%nThe change:%n%s",
            answer.name(),
            mutation.name(),
            seed,
            result.outcome(),
            mutation.outcome(),
            result.details().stream().limit(5).toList(),
            String.join("\n", change.stream().limit(12).toList())));
  }
}
