"""Decision of policies that are best available, when an endpoint is made.

The rules are those of `rmw_dds_common`: the highest level of service at which the endpoint matches all other ends
that are known. They are not decided again for ends that come later.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import product
from typing import Any

from eventchain_ros2.clock import Duration
from eventchain_ros2.qos import (
    BEST_AVAILABLE_DURATION,
    DurabilityPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
)

_DURATIONS = ("deadline", "liveliness_lease_duration")
_UNSTATED = (Duration(), BEST_AVAILABLE_DURATION)


def is_undecided(profile: QoSProfile) -> bool:
    """Return whether any policy of a profile is best available."""
    return (
        profile.reliability == ReliabilityPolicy.BEST_AVAILABLE
        or profile.durability == DurabilityPolicy.BEST_AVAILABLE
        or profile.liveliness == LivelinessPolicy.BEST_AVAILABLE
        or any(getattr(profile, name) == BEST_AVAILABLE_DURATION for name in _DURATIONS)
    )


def for_subscription(profile: QoSProfile, offers: Iterable[QoSProfile]) -> QoSProfile:
    """Return the decided profile of a subscription, for the profiles of all known publishers."""
    offers = list(offers)
    reliable = all(each.reliability == ReliabilityPolicy.RELIABLE for each in offers)
    kept = all(each.durability == DurabilityPolicy.TRANSIENT_LOCAL for each in offers)
    manual = all(each.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC for each in offers)
    return _decided(profile, offers, reliable=reliable, kept=kept, manual=manual, longest=True)


def for_publisher(profile: QoSProfile, requests: Iterable[QoSProfile]) -> QoSProfile:
    """Return the decided profile of a publisher, for the profiles of all known subscriptions."""
    requests = list(requests)
    manual = any(each.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC for each in requests)
    return _decided(profile, requests, reliable=True, kept=True, manual=manual, longest=False)


def for_anyone(profile: QoSProfile, *, publishes: bool) -> QoSProfile:
    """Return the profile that matches every other end, for want of knowledge about them."""
    if publishes:
        return _decided(profile, [], reliable=True, kept=True, manual=True, longest=False)
    return _decided(profile, [], reliable=False, kept=False, manual=False, longest=True)


class Undecided:
    """Publishers and subscriptions with policies that are decided once all ends are known."""

    def __init__(self) -> None:
        self._endpoints: list[Any] = []
        self._settled = False

    def add(self, endpoint: Any, *, publishes: bool, bridged: bool) -> None:
        """Decide later, if anything has to be; at once, if all nodes have started or other ends cannot be known."""
        profile = endpoint.qos_profile
        if not is_undecided(profile):
            return
        if bridged:
            endpoint.decide(for_anyone(profile, publishes=publishes))
        elif not self._settled:
            self._endpoints.append(endpoint)
        elif publishes:
            endpoint.decide(for_publisher(profile, (it.qos_profile for it in endpoint.topic.subscriptions)))
        else:
            endpoint.decide(for_subscription(profile, (it.qos_profile for it in endpoint.topic.publishers)))

    def settle(self) -> Iterator[tuple[Any, Any]]:
        """Decide; return the publishers and subscriptions that may match now."""
        endpoints, self._endpoints = self._endpoints, []
        self._settled = True
        return _settled(endpoints)


def _settled(endpoints: list[Any]) -> Iterator[tuple[Any, Any]]:
    """Decide the profiles of publishers and subscriptions by the ends of their topics, publishers first.

    Returns:
        the publishers and subscriptions that may match now, of which at least one was undecided.

    """
    for each in endpoints:
        if each in each.topic.publishers:
            each.decide(for_publisher(each.qos_profile, (it.qos_profile for it in each.topic.subscriptions)))
    for each in endpoints:
        if each in each.topic.subscriptions:
            each.decide(for_subscription(each.qos_profile, (it.qos_profile for it in each.topic.publishers)))
    for topic in {each.topic.name: each.topic for each in endpoints}.values():
        for publisher, subscription in product(topic.publishers, topic.subscriptions):
            if publisher in endpoints or subscription in endpoints:
                yield publisher, subscription


def _decided(
    profile: QoSProfile, others: list[QoSProfile], *, reliable: bool, kept: bool, manual: bool, longest: bool
) -> QoSProfile:
    policies = {name: getattr(profile, name) for name in QoSProfile.__slots__}
    if profile.reliability == ReliabilityPolicy.BEST_AVAILABLE:
        policies["reliability"] = ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT
    if profile.durability == DurabilityPolicy.BEST_AVAILABLE:
        policies["durability"] = DurabilityPolicy.TRANSIENT_LOCAL if kept else DurabilityPolicy.VOLATILE
    if profile.liveliness == LivelinessPolicy.BEST_AVAILABLE:
        policies["liveliness"] = LivelinessPolicy.MANUAL_BY_TOPIC if manual else LivelinessPolicy.AUTOMATIC
    for name in _DURATIONS:
        if getattr(profile, name) == BEST_AVAILABLE_DURATION:
            stated = [getattr(other, name) for other in others if getattr(other, name) not in _UNSTATED]
            policies[name] = (max if longest else min)(stated, default=Duration())
    return QoSProfile(**policies)
