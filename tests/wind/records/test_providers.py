"""Files of the usual providers are recognised and read in the units that their providers document.

Each small file holds the same made-up winds, written by the test as the provider writes them; the right drift
potential is computed by numpy from the numbers as written (``known.potential``).
"""

import numpy as np
import pytest

from tests.wind.records.known import HOURS, SIZE, potential, read_potential, winds

SPEEDS, DIRECTIONS = winds()
DATES = HOURS.astype(object)


def whole(unit):
    """The speeds as whole numbers of a unit."""
    return np.round(SPEEDS / SIZE[unit]).astype(int)


def rows(pattern, speeds=SPEEDS, directions=DIRECTIONS):
    """One line an hour, of its date t, speed s and direction d."""
    return [pattern.format(t=t, s=s, d=d) for t, s, d in zip(DATES, speeds, directions, strict=True)]


def isd():
    lines = [
        '"STATION","DATE","SOURCE","LATITUDE","LONGITUDE","NAME","REPORT_TYPE","QUALITY_CONTROL","WND","TMP"'
    ]
    body = rows(
        '"72494023234","{t:%Y-%m-%dT%H:%M:%S}","4","37.6","-122.4","SOMEWHERE, CA","FM-15","V020",'
        '"{d:03d},1,N,{s:04d},1","+0123,1"',
        whole("0.1 m/s"),
    )
    again = (
        body[3].replace("FM-15", "FM-12").replace(",N,", ",V,").replace(f'"{DIRECTIONS[3]:03d},1', '"999,9')
    )
    return lines + body[:4] + [again] + body[4:], whole("0.1 m/s") * 0.1


def isd_lite():
    pattern = "{t:%Y %m %d %H}   123    45 10132 {d:5d} {s:5d}     8 -9999 -9999"
    return rows(pattern, whole("0.1 m/s")), whole("0.1 m/s") * 0.1


def asos():
    lines = [
        "#DEBUG: Format Typ    -> onlycomma",
        "#DEBUG: Time Period   -> 2024",
        "station,valid,drct,sknt,gust",
    ]
    return lines + rows("SFO,{t:%Y-%m-%d %H:%M},{d}.00,{s}.00,M", whole("kn")), whole("kn") * SIZE["kn"]


def knmi():
    words = [
        "# BRON: KONINKLIJK NEDERLANDS METEOROLOGISCH INSTITUUT (KNMI)",
        "# STN         LON(east)   LAT(north)  ALT(m)      NAME",
        "# 209         4.518       52.465      0.00        IJmond",
        (
            "# DD        : Mean wind direction (in degrees) during the 10-minute period preceding the time "
            "of observation"
        ),
        "# FH        : Hourly mean wind speed (in 0.1 m/s)",
        (
            "# FF        : Mean wind speed (in 0.1 m/s) during the 10-minute period preceding the time of "
            "observation"
        ),
        "# FX        : Maximum wind gust (in 0.1 m/s) during the hourly division",
        "",
        "# STN,YYYYMMDD,   HH,   DD,   FH,   FF,   FX",
        " ",
    ]
    body = []
    for t, s, d in zip(DATES, whole("0.1 m/s"), DIRECTIONS, strict=True):
        date, hour = (t - np.timedelta64(1, "h").astype(object), 24) if t.hour == 0 else (t, t.hour)
        body.append(f"  209,{date:%Y%m%d},{hour:5d},{d:5d},  990,{s:5d},  120")
    return words + body, whole("0.1 m/s") * 0.1


def dwd():
    return [
        "STATIONS_ID;MESS_DATUM;QN_3;   F;   D;eor",
        *rows("         44;{t:%Y%m%d%H};    3;{s:6.1f};{d:5d};eor"),
    ], SPEEDS


def dwd_ten_minutes():
    return [
        "STATIONS_ID;MESS_DATUM;  QN;FF_10;DD_10;eor",
        *rows("         44;{t:%Y%m%d%H%M};    3;{s:6.1f};{d:5d};eor"),
    ], SPEEDS


def bom():
    heading = (
        "hm,Station Number,Year Month Day Hour Minutes in YYYY,MM,DD,HH24,MI format in Local time,Year "
        "Month Day Hour "
        "Minutes in YYYY,MM,DD,HH24,MI format in Local standard time,Wind speed in km/h,Quality of wind "
        "speed,Wind "
        "direction in degrees true,Quality of wind direction,Speed of maximum windgust in last 10 "
        "minutes in  km/h,"
        "Quality of speed of maximum windgust in last 10 minutes,AWS Flag,#"
    )
    time = "{t:%Y,%m,%d,%H,%M}"
    return [
        heading,
        *rows("hm,066037," + time + "," + time + ", {s},Y,{d},Y, 99,N,1,#", whole("km/h")),
    ], whole("km/h") / 3.6


def environment_canada():
    heading = (
        '"Longitude (x)","Latitude (y)","Station Name","Climate ID","Date/Time (LST)","Year","Month","Day",'
        '"Time (LST)","Temp (°C)","Temp Flag","Wind Dir (10s deg)","Wind Dir Flag","Wind Spd '
        '(km/h)","Wind Spd Flag"'
    )
    pattern = (
        '"-60.0","43.9","SABLE '
        'ISLAND","8204703","{t:%Y-%m-%d %H:%M}","{t:%Y}","{t:%m}","{t:%d}","{t:%H:%M}","1.2","",'
        '"{d}","","{s}",""'
    )
    return [heading, *rows(pattern, whole("km/h"), DIRECTIONS // 10)], whole("km/h") / 3.6


def ndbc():
    lines = ["#YY  MM DD hh mm WDIR WSPD GST  WVHT", "#yr  mo dy hr mn degT m/s  m/s     m"]
    return lines + rows("{t:%Y %m %d %H %M} {d:3d} {s:4.1f} 99.0 99.00"), SPEEDS


def ndbc_before_2005():
    return ["YY MM DD hh WD   WSPD GST  WVHT", *rows("{t:%y %m %d %H} {d:3d} {s:4.1f} 99.0 99.00")], SPEEDS


def power():
    lines = [
        "-BEGIN HEADER-",
        "NASA/POWER Source Native Resolution Hourly Data",
        "Dates (month/day/year): 01/30/2024 through 02/01/2024 in LST",
        (
            "The value for missing source data that cannot be computed or is outside of the sources "
            "availability: -999"
        ),
        "parameter(s):",
        "WS50M     MERRA-2 Wind Speed at 50 Meters (m/s)",
        "WS10M     MERRA-2 Wind Speed at 10 Meters (m/s)",
        "WD10M     MERRA-2 Wind Direction at 10 Meters (Degrees)",
        "-END HEADER-",
        "YEAR,MO,DY,HR,WS50M,WS10M,WD10M",
    ]
    return lines + rows("{t:%Y},{t.month},{t.day},{t.hour},22.22,{s},{d}.0"), SPEEDS


def open_meteo():
    lines = [
        "latitude,longitude,elevation,utc_offset_seconds,timezone,timezone_abbreviation",
        "52.5,13.4,38.0,0,GMT,GMT",
        "",
        (
            "time,wind_speed_100m (km/h),wind_gusts_10m (km/h),wind_speed_10m (km/h),wind_direction_100m (°),"
            "wind_direction_10m (°)"
        ),
    ]
    return lines + rows("{t:%Y-%m-%dT%H:%M},70.0,99.0,{s}.0,5,{d}", whole("km/h")), whole("km/h") / 3.6


def meteostat():
    heading = "time,temp,dwpt,rhum,prcp,snow,wdir,wspd,wpgt,pres,tsun,coco"
    return [
        heading,
        *rows("{t:%Y-%m-%d %H:%M:%S},1.5,0.1,90.0,,,{d}.0,{s}.0,,1013.2,,", whole("km/h")),
    ], whole("km/h") / 3.6


def meteostat_bulk():
    return rows("{t:%Y-%m-%d},{t.hour},1.5,0.1,90,,,{d},{s}.0,,1013.2,,", whole("km/h")), whole("km/h") / 3.6


def toa5():
    lines = [
        '"TOA5","mast","CR1000","12345","CR1000.Std.32","CPU:mast.CR1","00000","Hourly"',
        '"TIMESTAMP","RECORD","WS_ms_Max","WS_ms_S_WVT","WindDir_D1_WVT","WindDir_SD1_WVT"',
        '"TS","RN","meters/second","meters/second","Deg","Deg"',
        '"","","Max","WVc","WVc","WVc"',
    ]
    return lines + rows('"{t:%Y-%m-%d %H:%M:%S}",7,44.4,{s},{d},12.3'), SPEEDS


def hobo():
    lines = [
        '"Plot Title: mast"',
        (
            '"#","Date Time, GMT+01:00","Wind Speed, mph (LGR S/N: 9, SEN S/N: 8)","Gust Speed, mph (LGR '
            'S/N: 9)",'
            '"Wind Direction, ø (LGR S/N: 9)"'
        ),
    ]
    return lines + rows("1,{t:%m/%d/%y %I:%M:%S %p},{s},99,{d}", whole("mph")), whole("mph") * SIZE["mph"]


def aeolis():
    pattern = "{0:.18e} {1:.18e} {2:.18e}"
    triples = zip(np.arange(len(SPEEDS)) * 3600.0, SPEEDS, DIRECTIONS, strict=True)
    return [pattern.format(*triple) for triple in triples], SPEEDS


def era5_land():
    angle = np.radians(DIRECTIONS)
    east, north = -SPEEDS * np.sin(angle), -SPEEDS * np.cos(angle)
    pattern = "{t:%Y-%m-%d %H:%M:%S},{s!r},{d!r},23.5,15.5"
    return ["valid_time,u10,v10,latitude,longitude", *rows(pattern, east.tolist(), north.tolist())], SPEEDS


FORMATS = {
    "ISD global hourly": (isd, 10.0),
    "ISD-Lite": (isd_lite, 10.0),
    "ASOS": (asos, 10.0),
    "KNMI": (knmi, 10.0),
    "DWD": (dwd, 10.0),
    "DWD ": (dwd_ten_minutes, 10.0),
    "Bureau of Meteorology": (bom, 10.0),
    "Environment Canada": (environment_canada, 10.0),
    "NDBC": (ndbc, None),
    "NDBC ": (ndbc_before_2005, None),
    "NASA POWER": (power, 10.0),
    "Open-Meteo": (open_meteo, 10.0),
    "Meteostat": (meteostat, 10.0),
    "Meteostat ": (meteostat_bulk, 10.0),
    "TOA5": (toa5, None),
    "HOBO": (hobo, None),
    "AeoLiS": (aeolis, None),
    "ERA5": (era5_land, 10.0),
}


@pytest.mark.parametrize("name", FORMATS)
def test_the_format_of_a_provider_is_recognised_and_its_units_hold(tmp_path, name):
    make, height = FORMATS[name]
    lines, speeds = make()
    path = tmp_path / "download.txt"
    path.write_text("\n".join(lines) + "\n", "utf-8")
    found, record = read_potential(path)
    np.testing.assert_allclose(found, potential(speeds, DIRECTIONS), rtol=1e-9)
    assert name.strip() in record.format
    assert record.height == height
    assert (len(record), record.missing, record.duplicates) == (60, 0, int(make is isd))
    assert not record.warnings
    start = "2024-01-29T23:00:00" if make is hobo else "2024-01-30T00:00:00"  # its heading names GMT+01:00
    assert record.start is None if make is aeolis else str(record.start) == start
