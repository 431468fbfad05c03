package dev.eventchain.pipeline.simulate;

import dev.eventchain.contracts.latency.Deployment;
import dev.eventchain.contracts.timing.ResponseTimes.Outcome;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.results.LoadedProcessor;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.OptionalLong;

/** Processors of a chain for the report. */
final class ProcessorReport {

  private static final double MILLISECOND = 1e6;

  private ProcessorReport() {}

  static List<LoadedProcessor> of(EventChain chain) {
    return Deployment.of(chain).loads().stream().map(ProcessorReport::loaded).toList();
  }

  private static LoadedProcessor loaded(Deployment.Load load) {
    return new LoadedProcessor(
        String.valueOf(load.processor().getName()),
        load.utilisation().stream().mapToDouble(ProcessorReport::percent).findFirst(),
        percent(load.known()),
        load.ordered(),
        load.shares().stream().map(ProcessorReport::component).toList());
  }

  private static LoadedProcessor.Component component(Deployment.Share share) {
    SoftwareNode node = share.node();
    return new LoadedProcessor.Component(
        String.valueOf(node.getName()),
        node.isSetPriority() ? OptionalLong.of(node.getPriority()) : OptionalLong.empty(),
        share.utilisation().stream().mapToDouble(ProcessorReport::percent).findFirst(),
        share.response().bound().stream()
            .mapToDouble(time -> Math.ceil(time / 1e3) * 1e3 / MILLISECOND)
            .findFirst(),
        share.response().outcome() == Outcome.LATE);
  }

  private static double percent(BigDecimal part) {
    return part.movePointRight(2).setScale(1, RoundingMode.CEILING).doubleValue();
  }
}
