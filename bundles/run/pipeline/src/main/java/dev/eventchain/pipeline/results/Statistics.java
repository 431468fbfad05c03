package dev.eventchain.pipeline.results;

/**
 * A distribution, in ms.
 *
 * @param count number of values, at least 1
 */
public record Statistics(
    double minimum, double mean, double median, double percentile99, double maximum, long count) {}
