"""The codec that is built from the layout at run time with construct: the oracle of all generated ones.

>>> from fieldspec.reference import codec          # a DeviceCodec for a DeviceLayout
>>> codec(layout).records["point"].parse(data)     # a plain construct Struct
"""

from fieldspec.reference.frames import DeviceCodec, codec
from fieldspec.reference.records import CodecError

__all__ = ["CodecError", "DeviceCodec", "codec"]
