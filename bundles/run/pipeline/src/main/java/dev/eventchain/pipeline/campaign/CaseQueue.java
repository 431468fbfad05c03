package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.simulation.CaseSimulation;
import dev.eventchain.simulation.verdict.CaseResult;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;

/**
 * Cases that one side asks for while the other one simulates them. Each is simulated once, unless
 * its result was kept before.
 */
final class CaseQueue implements CaseSimulation.Numbers {

  private final Function<CampaignCase, Optional<CampaignRow>> kept;
  private final Map<CampaignCase, CompletableFuture<CaseResult>> answers = new HashMap<>();
  private final List<CampaignCase> cases = new ArrayList<>();
  private final Deque<Integer> open = new ArrayDeque<>();
  private boolean stopped;

  CaseQueue(Function<CampaignCase, Optional<CampaignRow>> kept) {
    this.kept = kept;
  }

  /**
   * Returns the result of a case, when it comes.
   *
   * @throws CancellationException if there will be none, as the result does later
   */
  synchronized CompletableFuture<CaseResult> ask(CampaignCase each) {
    if (stopped) {
      throw new CancellationException("the simulation has ended");
    }
    return answers.computeIfAbsent(each, this::enqueue);
  }

  private CompletableFuture<CaseResult> enqueue(CampaignCase each) {
    Optional<CampaignRow> known = kept.apply(each);
    if (known.isPresent()) {
      return CompletableFuture.completedFuture(known.get().result());
    }
    open.add(cases.size());
    cases.add(each);
    notifyAll();
    return new CompletableFuture<>();
  }

  @Override
  public synchronized OptionalInt next() {
    while (open.isEmpty() && !stopped) {
      try {
        wait();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return OptionalInt.empty();
      }
    }
    return stopped ? OptionalInt.empty() : OptionalInt.of(open.remove());
  }

  @Override
  public synchronized void stop() {
    stopped = true;
    answers.values().forEach(answer -> answer.cancel(false));
    notifyAll();
  }

  synchronized CampaignCase get(int number) {
    return cases.get(number);
  }

  /** Passes on the result of a case. */
  void done(int number, CaseResult result) {
    CompletableFuture<CaseResult> answer;
    synchronized (this) {
      answer = answers.get(cases.get(number));
    }
    answer.complete(result);
  }
}
